// Both ends of a sealed link over the impaired path, in virtual time.
#include "proto/link/datagram_link.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "proto/impaired/profiles.h"
#include "tests/bench/link/link_scenario.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;
using bench::link::Outcome;
using bench::link::Scenario;

Scenario shorter(Scenario scenario, double seconds) {
  scenario.seconds = seconds;
  return scenario;
}

TEST(DatagramLink, WithoutLossEachFrameComesAtOnceAndCostsLessThanATwentieth) {
  const Outcome outcome = run_telepalp(shorter(bench::link::over(0ms, 0.0, 1.0), 10.0));
  EXPECT_EQ(outcome.in_time, outcome.frames);
  EXPECT_EQ(outcome.wrong, 0U);
  EXPECT_LE(outcome.latency_ms.p99(), 1.0);
  EXPECT_LE(outcome.overhead_percent(), 5.0);
}

TEST(DatagramLink, CompletesFramesThroughLossWherePlainDatagramsDoNot) {
  const Scenario scenario = shorter(bench::link::over(50ms, 0.05, 1.0), 20.0);
  EXPECT_LE(run_plain_udp(scenario).in_time_percent(), 5.0);
  const Outcome outcome = run_telepalp(scenario);
  EXPECT_GE(outcome.in_time_percent(), 99.5);
  EXPECT_EQ(outcome.wrong, 0U);
}

TEST(DatagramLink, SurvivesTheHostileProfileAndNeverShowsAWrongFrame) {
  const auto profile = impaired::profile_named("hostile");
  Scenario scenario{.down = profile->down, .up = profile->up};
  scenario.seconds = 45.0;  // two outages
  const Outcome outcome = run_telepalp(scenario);
  EXPECT_EQ(outcome.wrong, 0U);
  EXPECT_GE(outcome.latency_ms.count(), outcome.frames);  // of two images each
}

TEST(DatagramLink, AThinPipeWithADeepBufferStaysFresh) {
  const impaired::Impairment down{.delay = 25ms, .rate_B_per_s = 2e6, .queue_B = 2U << 20U};
  const Scenario scenario{.down = down, .up = {.delay = 25ms}};
  const Outcome outcome = run_telepalp(scenario);
  EXPECT_LE(outcome.depth_age_ms.quantile(0.95), 200.0);
}

TEST(DatagramLink, APathThatIsSlowerThanTheDeadlineStillShowsImages) {
  const auto profile = impaired::profile_named("satellite");
  Scenario scenario{.down = profile->down, .up = profile->up};
  scenario.seconds = 20.0;
  const Outcome outcome = run_telepalp(scenario);
  EXPECT_GE(outcome.shown, outcome.frames * 9 / 10);
}

TEST(DatagramLink, ABrokenChainIsMendedByAKeyFrame) {
  Scenario scenario = shorter(bench::link::over(100ms, 0.05, 4.0), 30.0);
  scenario.depth_depends = true;
  const Outcome outcome = run_telepalp(scenario);
  EXPECT_EQ(outcome.wrong, 0U);
  EXPECT_GE(outcome.key_frames, 2U);
  EXPECT_LE(outcome.key_frames, outcome.frames / 4);
  EXPECT_GE(outcome.in_time_percent(), 85.0);
}

TEST(DatagramLink, IsSilentTowardsStrangers) {
  DatagramLinkSettings settings{.seal = {.number = 7}};
  DatagramLink server(settings, End::Server);
  std::vector<std::byte> stranger(200, std::byte{1});
  EXPECT_FALSE(server.received(stranger, SessionTime{1s}));
  for (Nanoseconds now = 1s; now < 3s; now += 1ms) EXPECT_FALSE(server.next(SessionTime{now}));
}

TEST(DatagramLink, ASenderThatIsNeverAnsweredStaysBounded) {
  DatagramLink server({.seal = {.number = 7}}, End::Server);
  std::size_t sent = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const SessionTime now{1s + i * 33ms};
    server.offer({.channel = 0, .number = i, .captured = now, .bytes = std::vector<std::byte>(100'000)});
    while (server.next(now)) ++sent;
  }
  EXPECT_LE(sent, 1100U);  // a mebibyte, then sixteen packets a second
}

TEST(PathEstimate, KnowsDelayLossAndRate) {
  PathEstimate path;
  std::uint64_t received = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {  // 1 MB/s, 40 ms, 2 % lost in pairs
    const SessionTime now{i * 1200us};
    path.sent(i, 1200, now);
    if (i < 40) continue;
    received += 1176;
    const auto settled = static_cast<std::uint32_t>(i - 39);
    path.on_feedback({.highest_sequence = i - 40 + 7,
                      .received_bytes = received,
                      .reported_ns = to_nanoseconds(now) - 20'000'000,
                      .held_us = 0,
                      .settled = settled,
                      .lost = settled / 50,
                      .bursts = settled / 100},
                     now);
  }
  EXPECT_NEAR(to_milliseconds(path.round_trip()), 33 * 1.2, 1.0);
  EXPECT_NEAR(path.loss(), 0.02, 0.002);
  EXPECT_NEAR(path.burst_packets(), 2.0, 0.2);
  EXPECT_NEAR(path.rate_B_per_s(), 980e3, 20e3);
  EXPECT_LE(path.in_flight_B(), 40U * 1200U);
}

/// A packet each 5 ms meets up to 60 ms of jitter, and so does each report on its way back. From packet 3000 on, each
/// also waits in a queue for `queue`. Returns the largest estimate of the queue after packet 2000.
Nanoseconds longest_queue(Nanoseconds queue) {
  PathEstimate path;
  std::mt19937_64 random(5);
  std::uniform_int_distribution<std::int64_t> jitter_us(0, 60'000);
  std::map<SessionTime, std::uint64_t> arrivals;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    path.sent(i, 1200, SessionTime{1s + i * 5ms});
    arrivals[SessionTime{1s + i * 5ms + 120ms + jitter_us(random) * 1us + (i < 3000 ? 0ms : queue)}] = i;
  }
  std::map<SessionTime, Feedback> reports;  // by arrival
  for (Feedback report{}; const auto& [at, packet] : arrivals) {
    report.highest_sequence = std::max(report.highest_sequence, packet);
    report.received_bytes += 1200;
    report.reported_ns = to_nanoseconds(at);
    if (report.highest_sequence == packet) reports[at + 120ms + jitter_us(random) * 1us] = report;
  }
  Nanoseconds longest{0};
  for (const auto& [at, report] : reports) {
    path.on_feedback(report, at);
    if (report.highest_sequence > 2000) longest = std::max(longest, path.queue_delay());
  }
  return longest;
}

TEST(PathEstimate, TellsJitterFromAQueue) {
  EXPECT_LE(longest_queue(0ms), 15ms);
  EXPECT_GE(longest_queue(40ms), 30ms);
}

/// A path that was measured for 10 s: `packets_lost` of each thousand packets are lost, each as a burst of one.
PathEstimate measured(Nanoseconds round_trip, std::uint32_t packets_lost) {
  PathEstimate path;
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    const SessionTime sent{1s + i * 1ms};
    path.sent(i, 1200, sent);
    const auto settled = static_cast<std::uint32_t>(i + 1);
    const std::uint32_t lost = settled * packets_lost / 1000;
    path.on_feedback({.highest_sequence = i,
                      .received_bytes = 1200 * (i + 1),
                      .reported_ns = to_nanoseconds(sent + round_trip / 2),
                      .settled = settled,
                      .lost = lost,
                      .bursts = lost},
                     sent + round_trip);
  }
  return path;
}

TEST(PathEstimate, FramesMayDependOnEachOtherWhereALossIsRareOrIsRepairedInTime) {
  EXPECT_FALSE(references_arrive(PathEstimate{}, 100ms)) << "a path that is not measured";
  EXPECT_TRUE(references_arrive(measured(50ms, 50), 100ms)) << "a loss is repaired after 90 ms";
  EXPECT_FALSE(references_arrive(measured(60ms, 50), 100ms)) << "a repair would take 105 ms";
  EXPECT_FALSE(references_arrive(measured(200ms, 10), 100ms));
  EXPECT_TRUE(references_arrive(measured(200ms, 0), 100ms)) << "nothing is lost";
}

TEST(PathEstimate, IgnoresFeedbackAboutWhatWasNotSent) {
  PathEstimate path;
  path.sent(0, 1200, SessionTime{1s});
  path.on_feedback({.highest_sequence = 1'000'000, .received_bytes = UINT64_MAX, .reported_ns = 5}, SessionTime{2s});
  EXPECT_EQ(path.in_flight_B(), 1200U);
}

}  // namespace
}  // namespace telepalp::link
