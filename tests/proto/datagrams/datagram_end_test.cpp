// Both ends of a connection's datagrams, in real time, over a wire in memory that can be cut.
#include "proto/wire/datagrams/datagram_end.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <deque>

#include "proto/wire/datagram_message.h"
#include "proto/wire/session_clock.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

struct Wire {
  boost::asio::io_context io;
  SessionClock clock = SessionClock::anchored_to_wall_clock();
  std::deque<Message> waiting;  // at the server
  std::vector<Message> arrived;
  std::vector<int> wishes;
  std::vector<DatagramPhase> server_phases, client_phases;
  std::function<void()> on_message;
  bool up_cut = false, down_cut = false;
  int lose_next_down = 0;
  std::size_t sent_down = 0;
  DatagramEnd server{io.get_executor(), {.number = 9}, link::End::Server, server_handlers()};
  DatagramEnd client{io.get_executor(), {.number = 9}, link::End::Client, client_handlers()};

  DatagramEnd::Handlers server_handlers() {
    return {.send =
                [this](std::span<const std::byte> datagram) {
                  ++sent_down;
                  if (lose_next_down > 0 && datagram.size() > 500) return --lose_next_down, true;
                  return down_cut || carry(datagram, client);
                },
            .next_frame = [this](Wanted wanted) -> std::shared_ptr<const link::SharedFrame> {
              const auto next = std::ranges::find_if(
                  waiting, [&](const Message& message) { return wanted == Wanted::Any || is_urgent(message.topic); });
              if (next == waiting.end()) return nullptr;
              const Message message = std::move(*next);
              waiting.erase(next);
              return frame_of(message, clock.now());
            },
            .on_frame = {},
            .on_key_frame_needed = [this](std::uint8_t channel) { wishes.push_back(channel); },
            .on_phase = [this](DatagramPhase phase) { server_phases.push_back(phase); },
            .now = [this] { return clock.now(); }};
  }
  DatagramEnd::Handlers client_handlers() {
    return {.send = [this](std::span<const std::byte> datagram) { return up_cut || carry(datagram, server); },
            .next_frame = {},
            .on_frame =
                [this](const link::Frame& frame) {
                  arrived.push_back(message_of(frame).value());
                  if (on_message) on_message();
                },
            .on_key_frame_needed = {},
            .on_phase = [this](DatagramPhase phase) { client_phases.push_back(phase); },
            .now = [this] { return clock.now(); }};
  }
  bool carry(std::span<const std::byte> datagram, DatagramEnd& to) {
    boost::asio::post(io, [&to, bytes = std::vector<std::byte>(datagram.begin(), datagram.end())] {
      (void)to.received(bytes);
      to.pump();
    });
    return true;
  }
  void start() {
    server.start();
    client.start();
  }
  void publish(std::uint64_t sequence, bool key_frame = true, std::size_t bytes = 90'000) {
    waiting.push_back(
        {kCameraDepth, clock.now(), std::make_shared<const std::string>(bytes, 'd'), sequence, key_frame});
    server.pump();
  }
  template <class Done>
  bool run_until(Done done, std::chrono::milliseconds patience = 5s) {
    const auto limit = std::chrono::steady_clock::now() + patience;
    while (!done() && std::chrono::steady_clock::now() < limit) io.run_one_for(5ms);
    return done();
  }
  [[nodiscard]] bool both_up() const {
    return server.phase() == DatagramPhase::Up && client.phase() == DatagramPhase::Up;
  }
};

TEST(FrameCache, AMessageForSeveralPeersIsOneFrameWhileOneOfThemKeepsIt) {
  FrameCache cache;
  const SessionTime now = session_time(10'000'000'000);
  Message message{kCameraDepth, now, std::make_shared<const std::string>(5000, 'd'), 7, true};
  const auto first = cache.frame_of(message, now);
  EXPECT_EQ(cache.frame_of(message, now + Nanoseconds(1000)), first);
  const Message copy{kCameraDepth, now, std::make_shared<const std::string>(5000, 'd'), 7, true};
  EXPECT_NE(cache.frame_of(copy, now), first) << "another message";
  const SessionTime much_later = now + std::chrono::seconds(5);
  EXPECT_NE(cache.frame_of(message, much_later), first) << "its deadline would be over";
  message.sequence = 8;
  EXPECT_NE(cache.frame_of(message, now), first) << "the same picture, published again";
}

TEST(DatagramEnd, BothEndsComeUpAndAMessageArrivesAsItWas) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  const SessionTime published = wire.clock.now();
  wire.waiting.push_back({kCameraColor, published, std::make_shared<const std::string>("JPEG"), 5'000'000'000, true});
  wire.server.pump();
  ASSERT_TRUE(wire.run_until([&] { return !wire.arrived.empty(); }));
  EXPECT_EQ(wire.arrived[0].topic.name, "/camera/color");
  EXPECT_EQ(wire.arrived[0].published, published);
  EXPECT_EQ(*wire.arrived[0].payload, "JPEG");
  EXPECT_EQ(wire.arrived[0].sequence, 5'000'000'000U);
  EXPECT_EQ(wire.server_phases, std::vector{DatagramPhase::Up});
}

TEST(DatagramEnd, SpeechArrivesBeforeTheImageThatBeganBeforeIt) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  wire.publish(1, true, 900'000);  // more than is sent in one go
  wire.waiting.push_back({kDoctorVoice, wire.clock.now(), std::make_shared<const std::string>("said"), 1, true});
  ASSERT_TRUE(wire.run_until([&] { return wire.arrived.size() == 2; }));
  EXPECT_EQ(wire.arrived[0].topic.name, "/doctor/voice");
}

TEST(DatagramEnd, AServerIsSilentUntilAClientIsHeardAndTakesNoFrameBefore) {
  Wire wire;
  wire.server.start();
  wire.publish(1);
  wire.run_until([] { return false; }, 300ms);
  EXPECT_EQ(wire.sent_down, 0U);
  EXPECT_EQ(wire.waiting.size(), 1U);
}

TEST(DatagramEnd, APathThatPassesOneWayAloneIsBlocked) {
  for (const bool up : {true, false}) {
    Wire wire;
    (up ? wire.up_cut : wire.down_cut) = true;
    wire.start();
    ASSERT_TRUE(wire.run_until([&] { return wire.client.phase() == DatagramPhase::Blocked; }, 2s));
    EXPECT_TRUE(wire.run_until([&] { return wire.server.phase() == DatagramPhase::Blocked; }, 2s));
    EXPECT_EQ(wire.client_phases, std::vector{DatagramPhase::Blocked});
  }
}

TEST(DatagramEnd, APathThatIsCutIsBlockedInASecondAndComesBack) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  wire.up_cut = wire.down_cut = true;
  const auto cut = std::chrono::steady_clock::now();
  ASSERT_TRUE(wire.run_until([&] { return wire.server.phase() == DatagramPhase::Blocked; }, 3s));
  EXPECT_LT(std::chrono::steady_clock::now() - cut, 1500ms);
  wire.up_cut = wire.down_cut = false;
  EXPECT_TRUE(wire.run_until([&] { return wire.both_up(); }, 4s));
  EXPECT_EQ(wire.server_phases, (std::vector{DatagramPhase::Up, DatagramPhase::Blocked, DatagramPhase::Up}));
}

TEST(DatagramEnd, ABrokenChainAsksForAKeyFrameAndItMendsTheChain) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  wire.publish(1);
  ASSERT_TRUE(wire.run_until([&] { return wire.arrived.size() == 1; }));
  wire.lose_next_down = 2;  // the whole frame: nothing is left to be repaired
  wire.publish(2, false, 1500);
  wire.publish(3, false, 1500);
  ASSERT_TRUE(wire.run_until([&] { return !wire.wishes.empty(); }));
  EXPECT_EQ(wire.wishes[0], 0) << "the channel of /camera/depth";
  EXPECT_EQ(wire.arrived.size(), 1U) << "a frame without its reference is not shown";
  wire.publish(4);
  ASSERT_TRUE(wire.run_until([&] { return wire.arrived.size() == 2; }));
  EXPECT_EQ(wire.arrived[1].sequence, 4U);
}

TEST(DatagramEnd, MayBeClosedByTheOwnerWhoGetsAMessage) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  wire.on_message = [&] { wire.client.close(); };
  for (std::uint64_t i = 1; i <= 5; ++i) wire.publish(i);
  wire.run_until([] { return false; }, 200ms);
  EXPECT_EQ(wire.arrived.size(), 1U);
}

TEST(DatagramEnd, AnOldStampDoesNotMakeAMessageLate) {
  Wire wire;
  wire.start();
  ASSERT_TRUE(wire.run_until([&] { return wire.both_up(); }));
  wire.waiting.push_back({kCameraDepth, session_time(1), std::make_shared<const std::string>("old"), 1, true});
  wire.server.pump();
  ASSERT_TRUE(wire.run_until([&] { return !wire.arrived.empty(); }));
  EXPECT_EQ(wire.arrived[0].published, session_time(1));
}

}  // namespace
}  // namespace telepalp::wire
