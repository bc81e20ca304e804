#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "messages/station.pb.h"
#include "proto/wire/client_link.h"
#include "server/hub/peer_listener.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

/// A server and its clients on one io_context, all on this thread, over real sockets on loopback.
struct Site {
  boost::asio::io_context io;
  Hub hub;
  wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  std::unique_ptr<PeerListener> listener = listen(0);

  std::unique_ptr<PeerListener> listen(std::uint16_t port) {
    auto made = PeerListener::listen(io, hub, clock, {.port = port});
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return std::move(made).value();
  }

  /// Runs the network until `done`, at most `patience`. Returns whether it was done.
  template <class Done>
  bool run_until(Done done, std::chrono::milliseconds patience = 5s) {
    const auto limit = std::chrono::steady_clock::now() + patience;
    while (!done() && std::chrono::steady_clock::now() < limit) io.run_one_for(5ms);
    return done();
  }
};

struct Client {
  std::vector<wire::Message> messages;
  std::vector<std::string> states;
  wire::ClientLink link;

  Client(Site& site, std::vector<std::string> topics, std::string name = "test")
      : link(site.io,
             {.port = site.listener->port(),
              .name = std::move(name),
              .subscribes = std::move(topics),
              .publishes = {wire::kStationState, wire::kStationEvents}},
             {.on_message = [this](const wire::Message& message) { messages.push_back(message); },
              .on_state = [this](wire::LinkState state,
                                 const std::string&) { states.emplace_back(wire::name(state)); }}) {
    link.start();
  }
  bool connected() const { return link.state() == wire::LinkState::Connected; }
};

wire::Message message(const wire::Topic& topic, const std::string& payload) {
  return {topic, session_time(1), std::make_shared<const std::string>(payload)};
}

wire::Message station_state(std::int64_t stamp_ns) {
  msg::StationState state;
  state.set_stamp_ns(static_cast<std::uint64_t>(stamp_ns));
  return wire::make_message(wire::kStationState, session_time(stamp_ns), state);
}

TEST(Link, AMessageReachesOnlyThoseWhoAskedForItsTopic) {
  Site site;
  Client depth(site, {"/camera/*"});
  Client clock(site, {"/clock"});
  ASSERT_TRUE(site.run_until([&] { return depth.connected() && clock.connected(); }));
  site.hub.publish(message(wire::kCameraDepth, std::string(300'000, 'd')));
  site.hub.publish(message(wire::kClock, "c"));
  ASSERT_TRUE(site.run_until([&] { return depth.messages.size() == 1 && clock.messages.size() == 1; }));
  EXPECT_EQ(depth.messages[0].topic.name, "/camera/depth");
  EXPECT_EQ(*depth.messages[0].payload, std::string(300'000, 'd'));
  EXPECT_EQ(clock.messages[0].topic.name, "/clock");
}

TEST(Link, TheSessionClockIsKnownWithinAMillisecondOnceConnected) {
  Site site;
  site.clock = wire::SessionClock{site.clock.offset() + 1h};
  site.listener = site.listen(0);
  Client client(site, {});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  EXPECT_LT(std::chrono::abs(client.link.clock().offset() - site.clock.offset()), 1ms);
}

TEST(Link, WhatAStationPublishesComesToTheOtherSubscribers) {
  Site site;
  Client station(site, {}, "station");
  Client viewer(site, {"/station/*"}, "viewer");
  ASSERT_TRUE(site.run_until([&] { return station.connected() && viewer.connected(); }));
  EXPECT_TRUE(station.link.publish(station_state(42)));
  ASSERT_TRUE(site.run_until([&] { return viewer.messages.size() == 1; }));
  EXPECT_EQ(viewer.messages[0].topic.name, "/station/state");
  EXPECT_EQ(viewer.messages[0].published, session_time(42));
}

TEST(Link, ALateJoinerIsGivenTheCameraModelAndStatus) {
  Site site;
  site.hub.publish(message(wire::kCameraInfo, "info"));
  site.hub.publish(message(wire::kCameraDepth, "gone by"));
  Client late(site, {"/camera/*"});
  ASSERT_TRUE(site.run_until([&] { return late.messages.size() == 1; }));
  EXPECT_EQ(*late.messages[0].payload, "info");
}

TEST(Link, AServerThatGoesAwayAndComesBackIsFoundAgain) {
  Site site;
  Client client(site, {"/clock"});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  const std::uint16_t port = site.listener->port();
  site.listener->close("stopped for the test");
  ASSERT_TRUE(site.run_until([&] { return client.link.state() != wire::LinkState::Connected; }));
  ASSERT_TRUE(site.run_until([&] { return site.listener->peers() == 0; }));
  site.listener = site.listen(port);
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  site.hub.publish(message(wire::kClock, "back"));
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 1; }));
  EXPECT_EQ(client.link.counts().connections, 2u);
  EXPECT_NE(std::find(client.states.begin(), client.states.end(), "lost"), client.states.end());
}

}  // namespace
}  // namespace telepalp::server
