// The jitter buffer of speech, over networks as they are: late, twice, in another order, never.

#include "codec/voice_playout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "tests/support/speech.h"

namespace telepalp::codec {
namespace {

using namespace std::chrono_literals;

struct Arrival {
  SessionTime at{};
  VoicePacket packet;
};

/// Packets of frame 0 on, coded in order, as they leave the microphone: each when its 20 ms have been said.
class Talker {
 public:
  explicit Talker(std::uint64_t name = 1) : name_(name) {}
  VoicePacket packet(std::uint32_t number, std::uint32_t begun = 0) {
    return {.talker = name_, .number = number, .begun = begun, .opus = encoder_.encode(support::speech(number))};
  }

 private:
  std::uint64_t name_;
  VoiceEncoder encoder_;
};

SessionTime said(std::uint32_t number) { return session_time(0) + 1s + (number + 1) * Nanoseconds(kVoiceFrameTime); }

struct Heard {
  VoicePlayout::Counts counts;
  std::vector<VoicePlayout::Played> frames;
  Nanoseconds longest_delay{};
  std::size_t count(VoicePlayout::Kind kind) const {
    return static_cast<std::size_t>(std::ranges::count(frames, kind, &VoicePlayout::Played::kind));
  }
};

/// Plays from 1 s on for `seconds`, 20 ms at a time. `period`: of the loudspeaker's clock.
Heard listen(std::vector<Arrival> arrivals, double seconds, Nanoseconds period = kVoiceFrameTime) {
  std::ranges::stable_sort(arrivals, {}, &Arrival::at);
  VoicePlayout playout;
  Heard heard;
  auto next = arrivals.begin();
  for (SessionTime now = session_time(0) + 1s + 7ms; now < session_time(0) + 1s + from_seconds(seconds);
       now += period) {
    for (; next != arrivals.end() && next->at <= now; ++next) playout.add(next->packet, next->at);
    heard.frames.push_back(playout.next(now));
    heard.longest_delay = std::max(heard.longest_delay, playout.delay());
  }
  heard.counts = playout.counts();
  return heard;
}

/// `arrives(number)`: the times at which the packet arrives; none: it is lost.
std::vector<Arrival> over_network(std::uint32_t frames,
                                  const std::function<std::vector<SessionTime>(std::uint32_t)>& arrives) {
  static const std::vector<VoicePacket> said_once = [] {  // coding takes most of the time of these tests
    Talker talker;
    std::vector<VoicePacket> packets;
    for (std::uint32_t number = 0; number < 200; ++number) packets.push_back(talker.packet(number));
    return packets;
  }();
  std::vector<Arrival> arrivals;
  for (std::uint32_t number = 0; number < frames; ++number) {
    VoicePacket packet = said_once[number % said_once.size()];
    packet.number = number;
    for (const SessionTime at : arrives(number)) arrivals.push_back({at, packet});
  }
  return arrivals;
}

TEST(VoicePlayout, AnEvenPathPlaysEachFrameOnceInOrder) {
  const Heard heard = listen(over_network(500, [](auto n) { return std::vector{said(n) + 30ms}; }), 12.0);
  EXPECT_EQ(heard.counts.played, 500u);
  EXPECT_EQ(heard.counts.concealed + heard.counts.skipped + heard.counts.stretched + heard.counts.late, 0u);
  EXPECT_LE(heard.longest_delay, 5ms);
  std::uint32_t expected = 0;
  for (const auto& frame : heard.frames)
    if (frame.kind == VoicePlayout::Kind::Voice) {
      EXPECT_EQ(frame.number, expected++);
    }
}

TEST(VoicePlayout, TheSoundIsTheOneThatWasSaid) {
  const Heard heard = listen(over_network(200, [](auto n) { return std::vector{said(n) + 30ms}; }), 4.0);
  std::vector<float> said_samples, played;
  for (std::uint32_t n = 0; n < 200; ++n) {
    const VoiceSamples frame = support::speech(n);
    said_samples.insert(said_samples.end(), frame.begin(), frame.end());
  }
  for (const auto& frame : heard.frames) played.insert(played.end(), frame.samples.begin(), frame.samples.end());
  EXPECT_GT(support::aligned(said_samples, played, 6'000).correlation, 0.8);
}

TEST(VoicePlayout, TenPercentLossInBurstsOfFourIsConcealedAndCounted) {
  const auto is_lost = [](std::uint32_t n) { return n % 40 >= 20 && n % 40 < 24; };
  const Heard heard =
      listen(over_network(
                 1'000, [&](auto n) { return is_lost(n) ? std::vector<SessionTime>{} : std::vector{said(n) + 30ms}; }),
             22.0);
  EXPECT_EQ(heard.counts.played, 900u);
  EXPECT_EQ(heard.counts.restored + heard.counts.concealed, 100u);
  EXPECT_GE(heard.counts.restored, 24u) << "the last frame of each burst comes from the packet after it";
  EXPECT_LE(heard.longest_delay, 25ms) << "which comes a frame later";
  EXPECT_EQ(heard.count(VoicePlayout::Kind::Voice), 900u);
}

TEST(VoicePlayout, LostPacketsThatComeWithALaterOneAreAllPlayedOnceTheDelayCoversThem) {
  const auto arrives = [](std::uint32_t n) {
    const bool in_burst = n % 40 >= 20 && n % 40 < 24;
    return std::vector{in_burst ? said(n / 40 * 40 + 24) + 30ms : said(n) + 30ms};
  };
  const Heard heard = listen(over_network(1'500, arrives), 32.0);
  EXPECT_LE(heard.counts.concealed, 8u) << "in the first bursts";
  EXPECT_GE(heard.counts.played, 1'485u);
  EXPECT_GE(heard.longest_delay, 80ms);
  EXPECT_LE(heard.longest_delay, 86ms);
}

TEST(VoicePlayout, AnotherOrderIsPutRight) {
  const Heard heard =
      listen(over_network(600, [](auto n) { return std::vector{said(n) + (n % 3 == 0 ? 65ms : 20ms)}; }), 14.0);
  EXPECT_GE(heard.counts.played, 597u);
  std::uint32_t last = 0;
  for (const auto& frame : heard.frames)
    if (frame.kind == VoicePlayout::Kind::Voice) {
      EXPECT_GE(frame.number, last);
      last = frame.number;
    }
}

TEST(VoicePlayout, DuplicatesAreLeftOut) {
  const Heard heard = listen(over_network(300,
                                          [](auto n) {
                                            return std::vector{said(n) + 20ms, said(n) + 22ms, said(n) + 120ms};
                                          }),
                             8.0);
  EXPECT_EQ(heard.counts.played, 300u);
  EXPECT_EQ(heard.count(VoicePlayout::Kind::Voice), 300u);
  EXPECT_LE(heard.longest_delay, 5ms) << "a copy does not make the path look slow";
}

TEST(VoicePlayout, ClocksThatDriftApartLoseOrStretchSingleFrames) {
  for (const Nanoseconds period : {Nanoseconds(19'990'000), Nanoseconds(20'010'000)}) {  // 500 ppm
    const Heard heard = listen(over_network(3'000, [](auto n) { return std::vector{said(n) + 30ms}; }), 60.0, period);
    EXPECT_GE(heard.counts.played, 2'990u) << period.count();
    EXPECT_LE(heard.counts.skipped + heard.counts.stretched, 4u) << "30 ms in 60 s";
    EXPECT_EQ(heard.counts.concealed, 0u);
  }
}

TEST(VoicePlayout, APauseOfTheMicrophoneIsNoLoss) {
  Talker talker;
  std::vector<Arrival> arrivals;
  for (std::uint32_t n = 0; n < 100; ++n) arrivals.push_back({said(n) + 20ms, talker.packet(n)});
  for (std::uint32_t n = 400; n < 500; ++n) arrivals.push_back({said(n) + 20ms, talker.packet(n, 400)});
  const Heard heard = listen(arrivals, 12.0);
  EXPECT_EQ(heard.counts.played, 200u);
  EXPECT_EQ(heard.counts.concealed, 0u);
  EXPECT_GE(heard.count(VoicePlayout::Kind::Silence), 280u);
}

TEST(VoicePlayout, WhatIsLostInAnOutageIsCountedAndTheNewestIsPlayedAfterIt) {
  const auto arrives = [](std::uint32_t n) {
    return n >= 100 && n < 150 ? std::vector{said(150) + 20ms} : std::vector{said(n) + 20ms};
  };
  const Heard heard = listen(over_network(400, arrives), 9.0);
  EXPECT_GE(heard.counts.skipped + heard.counts.concealed + heard.counts.late, 25u);
  EXPECT_GE(heard.counts.played, 330u);
  EXPECT_LE(heard.longest_delay, 400ms);
}

TEST(VoicePlayout, AClockThatJumpsBeginsAnew) {
  for (const Nanoseconds jump : {Nanoseconds(5s), Nanoseconds(-500ms)}) {
    const auto arrives = [&](std::uint32_t n) { return std::vector{said(n) + 1s + (n < 200 ? 0ms : jump)}; };
    std::vector<Arrival> arrivals = over_network(400, arrives);
    const Heard heard = listen(arrivals, 18.0);
    EXPECT_GE(heard.counts.jumps, 1u) << jump.count();
    EXPECT_GE(heard.counts.played, 330u) << jump.count();
  }
}

TEST(VoicePlayout, AnotherTalkerBeginsAnew) {
  Talker first(1), second(2);
  std::vector<Arrival> arrivals;
  for (std::uint32_t n = 0; n < 100; ++n) arrivals.push_back({said(n) + 20ms, first.packet(n)});
  for (std::uint32_t n = 0; n < 100; ++n) arrivals.push_back({said(n + 120) + 20ms, second.packet(n)});
  const Heard heard = listen(arrivals, 7.0);
  EXPECT_EQ(heard.counts.played, 200u);
  EXPECT_EQ(heard.counts.concealed, 0u);
}

TEST(VoicePlayout, ASessionPlayedAtAnotherSpeedStaysBounded) {
  for (const double speed : {0.1, 10.0}) {
    const auto arrives = [&](std::uint32_t n) {
      return std::vector{session_time(0) + 1s + from_seconds(0.02 * n / speed)};
    };
    const Heard heard = listen(over_network(500, arrives), speed < 1.0 ? 40.0 : 3.0);
    EXPECT_LE(heard.counts.played, 500u);
    EXPECT_LE(heard.longest_delay, VoicePlayout::kMostDelay);
  }
}

TEST(VoicePlayout, AnyPacketsKeepItBounded) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::uint32_t> any, small(0, 60);
  Talker talker;
  const std::string opus = talker.packet(0).opus;
  VoicePlayout playout;
  SessionTime now = session_time(0) + 1s;
  for (int i = 0; i < 5'000; ++i) {
    VoicePacket packet{.talker = small(random) / 50, .number = small(random) < 50 ? small(random) : any(random)};
    packet.begun = small(random) < 50 ? 0 : any(random);
    packet.opus = small(random) < 50 ? opus : opus.substr(0, small(random));
    playout.add(packet, now);
    now += Nanoseconds(1ms) * (std::int64_t{small(random)} - 10);
    for (const float sample : playout.next(now).samples) ASSERT_TRUE(std::isfinite(sample)) << "seed 11, step " << i;
    ASSERT_LE(playout.delay(), VoicePlayout::kMostDelay);
  }
}

}  // namespace
}  // namespace telepalp::codec
