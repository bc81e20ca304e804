#include <gtest/gtest.h>

#include <algorithm>

#include "tests/server/delay_relay.h"
#include "tests/server/loopback_site.h"

namespace telepalp::server {
namespace {

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

TEST(Link, TheSessionClockIsKnownWithinItsStatedUncertaintyOnceConnected) {
  Site site;
  site.clock = wire::SessionClock{site.clock.offset() + 1h};
  site.listener = site.listen(0);
  Client client(site, {});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  EXPECT_LE(std::chrono::abs(client.link.clock().offset() - site.clock.offset()), client.link.clock_uncertainty());
  EXPECT_LT(client.link.clock_uncertainty(), 100ms);  // half a round trip on a busy machine
}

TEST(Link, ALinkWithADelayOfATenthOfASecondIsConnectedAtItsSecondRoundTrip) {
  Site site;
  site.clock = wire::SessionClock{site.clock.offset() + 1h};
  site.listener = site.listen(0);
  DelayRelay relay(site.io, site.listener->port(), 100ms);
  Client client(site, {}, "far", relay.port());
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }, 1200ms));
  site.run_until([] { return false; }, 300ms);  // the other eager probes
  EXPECT_LT(std::chrono::abs(client.link.clock().offset() - site.clock.offset()), 10ms);
  EXPECT_GE(client.link.clock_uncertainty(), 100ms);
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

std::uint32_t sender_of(const wire::Message& message) {
  msg::StationState state;
  EXPECT_TRUE(state.ParseFromString(*message.payload));
  return state.sender();
}

TEST(Link, EachPeersMessagesCarryItsOwnNumberWhateverItWrites) {
  Site site;
  Client station(site, {}, "station");
  Client forger(site, {}, "forger");
  Client viewer(site, {"/station/*"}, "viewer");
  ASSERT_TRUE(site.run_until([&] { return station.connected() && forger.connected() && viewer.connected(); }));
  EXPECT_TRUE(station.link.publish(station_state(1)));
  ASSERT_TRUE(site.run_until([&] { return viewer.messages.size() == 1; }));
  const std::uint32_t number = sender_of(viewer.messages[0]);
  EXPECT_NE(number, 0U);
  msg::StationState forged;
  forged.set_sender(number);
  EXPECT_TRUE(forger.link.publish(wire::make_message(wire::kStationState, session_time(2), forged)));
  ASSERT_TRUE(site.run_until([&] { return viewer.messages.size() == 2; }));
  EXPECT_NE(sender_of(viewer.messages[1]), number);
  const auto subscribers = site.hub.subscriber_counts();
  EXPECT_TRUE(std::any_of(subscribers.begin(), subscribers.end(),
                          [&](const auto& count) { return count.name == "station" && count.sender == number; }));
}

TEST(Link, APeerThatComesBackHasTheSameNumber) {
  Site site;
  Client station(site, {"/station/*"}, "station");
  ASSERT_TRUE(site.run_until([&] { return station.connected(); }));
  EXPECT_TRUE(station.link.publish(station_state(1)));
  ASSERT_TRUE(site.run_until([&] { return station.messages.size() == 1; }));
  const std::uint16_t port = site.listener->port();
  site.listener->close("stopped for the test");
  ASSERT_TRUE(site.run_until([&] { return site.listener->peers() == 0 && !station.connected(); }));
  site.listener = site.listen(port);
  ASSERT_TRUE(site.run_until([&] { return station.connected(); }));
  EXPECT_TRUE(station.link.publish(station_state(2)));
  ASSERT_TRUE(site.run_until([&] { return station.messages.size() == 2; }));
  EXPECT_EQ(sender_of(station.messages[1]), sender_of(station.messages[0]));
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

TEST(Link, WhatTheHubDroppedForASubscriberIsSeenAsAGapInTheNumbers) {
  Site site;
  Client client(site, {"/camera/depth"});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  site.hub.publish(message(wire::kCameraDepth, "1"));
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 1; }));
  // The network does not run meanwhile: one message goes to the socket at once, two wait, the others are dropped.
  for (int number = 2; number <= 10; ++number) site.hub.publish(message(wire::kCameraDepth, std::to_string(number)));
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 4; }));
  EXPECT_EQ(*client.messages.back().payload, "10");
  EXPECT_EQ(client.messages.back().sequence, 10u);
  EXPECT_EQ(client.link.received().at(wire::kCameraDepth.name).missed, 6u);
  EXPECT_EQ(site.hub.subscriber_counts().front().dropped(), 6u);
}

TEST(Link, AnEventPublishedWhileThereIsNoConnectionWaitsAndAStateDoesNot) {
  Site site;
  const std::uint16_t port = site.listener->port();
  site.listener.reset();
  Client station(site, {}, "station", port);
  EXPECT_FALSE(station.link.publish(station_state(1)));
  EXPECT_FALSE(station.link.publish(wire::make_message(wire::kStationEvents, session_time(2), msg::StationEvent())));
  site.listener = site.listen(port);
  ASSERT_TRUE(site.run_until([&] { return site.hub.topic_counts().contains(wire::kStationEvents.name); }));
  EXPECT_FALSE(site.hub.topic_counts().contains(wire::kStationState.name));
  EXPECT_EQ(station.link.counts().not_sent, 1u);
}

TEST(Link, StopSendsWhatIsQueuedBeforeItsGoodbye) {
  Site site;
  Client station(site, {}, "station");
  ASSERT_TRUE(site.run_until([&] { return station.connected(); }));
  for (int number = 1; number <= 50; ++number) EXPECT_TRUE(station.link.publish(station_state(number)));
  station.link.stop("the examination is over");
  ASSERT_TRUE(site.run_until([&] { return site.listener->peers() == 0; }));
  EXPECT_EQ(site.hub.topic_counts().at(wire::kStationState.name).published, 50u);
  EXPECT_EQ(site.notes.back(),
            "station at " + site.address_of("station") + " disconnected: peer left: the examination is over");
}

TEST(Link, AServerOfAnotherProtocolVersionIsNamedAsSuch) {
  Site site;
  boost::asio::ip::tcp::acceptor other(site.io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  boost::asio::ip::tcp::socket accepted(site.io);
  msg::Control hello;
  hello.mutable_hello()->set_protocol(7);
  const std::string bytes = control_frame(hello);
  other.async_accept(
      accepted, [&](const boost::system::error_code&) { boost::asio::write(accepted, boost::asio::buffer(bytes)); });
  Client client(site, {}, "test", other.local_endpoint().port());
  ASSERT_TRUE(site.run_until([&] {
    return !client.details.empty() &&
           client.details.back().find("speaks version 7 of the wire protocol instead of version 1 or 2") !=
               std::string::npos;
  }));
  EXPECT_EQ(client.link.state(), wire::LinkState::Refused);
  bool tried_again = false;
  other.async_accept(accepted, [&](const boost::system::error_code& code) { tried_again = !code; });
  EXPECT_FALSE(site.run_until([&] { return tried_again; }, 500ms)) << "another try would end the same way";
}

TEST(Link, AFrameOfAnotherProtocolVersionEndsTheLinkToo) {
  Site site;
  boost::asio::ip::tcp::acceptor other(site.io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  boost::asio::ip::tcp::socket accepted(site.io);
  std::string bytes = control_frame(msg::Control());
  bytes[4] = 3;  // the header's version
  other.async_accept(
      accepted, [&](const boost::system::error_code&) { boost::asio::write(accepted, boost::asio::buffer(bytes)); });
  Client client(site, {}, "test", other.local_endpoint().port());
  EXPECT_TRUE(site.run_until([&] { return client.link.state() == wire::LinkState::Refused; }));
  EXPECT_NE(client.details.back().find("it has version 3 of the wire protocol instead of 1 or 2"), std::string::npos)
      << client.details.back();
}

TEST(Link, ALinkThatIsDestroyedWhileItConnectsLeavesNothingBehind) {
  Site site;
  for (int round = 0; round < 20; ++round) {
    auto client = std::make_unique<Client>(site, std::vector<std::string>{"*"});
    for (int i = 0; i < round; ++i) site.io.run_one_for(1ms);
    client.reset();
  }
  EXPECT_TRUE(site.run_until([&] { return site.listener->peers() == 0; }));
}

TEST(Link, AClientWithoutReferenceGetsAKeyFrame) {
  Site site;
  int asked = 0;
  site.hub.on_key_frame_request([&](std::string_view) { ++asked; });
  Client client(site, {"/camera/depth"});
  ASSERT_TRUE(site.run_until([&] { return client.connected(); }));
  const auto publish = [&](int number, bool is_key) {
    site.hub.publish({wire::kCameraDepth, session_time(number), std::make_shared<const std::string>("d"), 0, is_key});
  };
  publish(1, true);
  publish(2, false);
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 2; }));
  client.link.request_key_frame(client.messages.back());
  ASSERT_TRUE(site.run_until([&] { return asked == 1; }));
  publish(3, false);
  publish(4, true);
  ASSERT_TRUE(site.run_until([&] { return client.messages.size() == 3; }));
  EXPECT_EQ(client.messages.back().published, session_time(4));
}

}  // namespace
}  // namespace telepalp::server
