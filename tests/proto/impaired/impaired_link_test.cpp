#include "proto/impaired/impaired_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "proto/impaired/profiles.h"

namespace telepalp::impaired {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kPacket_B = 1200;

/// A packet that carries its number.
Packet numbered(std::uint32_t number, bool stream = false) {
  Packet packet{.bytes = std::vector<std::byte>(kPacket_B), .flow = 1, .stream = stream};
  std::memcpy(packet.bytes.data(), &number, sizeof number);
  return packet;
}

struct Arrived {
  Nanoseconds at;
  std::uint32_t number;
  std::vector<std::byte> bytes;
};

/// Sends `count` packets, one each `spacing`, and returns all that arrives within a minute.
std::vector<Arrived> run(ImpairedLink& link, std::uint32_t count, Nanoseconds spacing = 1ms, bool stream = false) {
  std::vector<Arrived> arrived;
  const auto receive = [&](Nanoseconds until) {
    while (const auto at = link.next_arrival()) {
      if (*at > until) return;
      const Packet packet = *link.receive(*at);
      std::uint32_t number = 0;
      std::memcpy(&number, packet.bytes.data(), sizeof number);
      arrived.push_back({*at, number, packet.bytes});
    }
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    receive(i * spacing);
    link.send(i * spacing, numbered(i, stream));
  }
  receive(count * spacing + 60s);
  return arrived;
}

double lost_share(const ImpairedLink& link) {
  return static_cast<double>(link.statistics().lost) / static_cast<double>(link.statistics().sent);
}

TEST(ImpairedLink, WithoutImpairmentEachPacketArrivesAtOnceAndInOrder) {
  ImpairedLink link({}, 1);
  const auto arrived = run(link, 100);
  ASSERT_EQ(arrived.size(), 100U);
  for (std::uint32_t i = 0; i < 100; ++i) {
    EXPECT_EQ(arrived[i].number, i);
    EXPECT_EQ(arrived[i].at, i * 1ms);
    EXPECT_EQ(arrived[i].bytes, numbered(i).bytes);
  }
}

TEST(ImpairedLink, JitterIsUniformAroundTheDelayAndNeverNegative) {
  ImpairedLink link({.delay = 50ms, .jitter = 20ms}, 2);
  const auto arrived = run(link, 5000);
  Nanoseconds least = 1h, most = 0ns, sum = 0ns;
  for (const Arrived& one : arrived) {
    const Nanoseconds delay = one.at - one.number * 1ms;
    least = std::min(least, delay);
    most = std::max(most, delay);
    sum += delay;
  }
  ASSERT_EQ(arrived.size(), 5000U);
  EXPECT_NEAR(to_milliseconds(least), 30.0, 0.1);
  EXPECT_NEAR(to_milliseconds(most), 70.0, 0.1);
  EXPECT_NEAR(to_milliseconds(sum) / 5000.0, 50.0, 0.5);

  ImpairedLink more_jitter_than_delay({.delay = 5ms, .jitter = 100ms}, 2);
  for (const Arrived& one : run(more_jitter_than_delay, 1000)) EXPECT_GE(one.at, one.number * 1ms);
}

TEST(ImpairedLink, LossHasTheShareAndTheMeanBurstThatAreAsked) {
  for (const double burst : {1.0, 4.0}) {
    ImpairedLink link({.loss = 0.1, .burst_packets = burst}, 3);
    const auto arrived = run(link, 200'000);
    std::size_t bursts = 0;
    for (std::size_t i = 1; i < arrived.size(); ++i)
      if (arrived[i].number != arrived[i - 1].number + 1) ++bursts;
    EXPECT_NEAR(lost_share(link), 0.1, 0.004);
    const double mean = static_cast<double>(link.statistics().lost) / static_cast<double>(bursts);
    EXPECT_NEAR(mean, std::max(burst, 1.0 / 0.9), 0.05 * burst);  // independent losses at 10 %: 1.11 in a row
  }
}

TEST(ImpairedLink, AllOrNothingIsLostAtTheEndsOfTheRange) {
  ImpairedLink deaf({.loss = 1.0}, 4);
  EXPECT_TRUE(run(deaf, 1000).empty());
  ImpairedLink clear({.loss = 0.0, .burst_packets = 100.0}, 4);
  EXPECT_EQ(run(clear, 1000).size(), 1000U);
}

TEST(ImpairedLink, TheBottleneckDelaysByItsRateAndDropsWhatDoesNotFit) {
  ImpairedLink link({.rate_B_per_s = 1.2e6, .queue_B = 12'000}, 5);  // a packet a millisecond, room for ten
  const auto arrived = run(link, 100, 0ms);
  ASSERT_EQ(arrived.size(), 10U);
  EXPECT_EQ(link.statistics().dropped, 90U);
  for (std::uint32_t i = 0; i < 10; ++i) EXPECT_NEAR(to_milliseconds(arrived[i].at), i + 1.0, 1e-3);
  EXPECT_EQ(link.queued_B(10ms), 0U);
}

TEST(ImpairedLink, ReorderedDuplicatedAndCorruptedPacketsAreAsManyAsAsked) {
  ImpairedLink link({.delay = 20ms, .reorder = 0.05, .reorder_by = 10ms, .duplicate = 0.03, .corrupt = 0.02}, 6);
  const auto arrived = run(link, 20'000);
  std::set<std::uint32_t> seen;
  std::size_t overtaken = 0, damaged = 0;
  std::uint32_t newest = 0;
  for (const Arrived& one : arrived) {
    if (one.bytes != numbered(one.number).bytes) ++damaged;
    if (one.number < newest && seen.insert(one.number).second) ++overtaken;
    seen.insert(one.number);
    newest = std::max(newest, one.number < 20'000 ? one.number : newest);  // a damaged number may be any
  }
  EXPECT_NEAR(static_cast<double>(overtaken), 1000.0, 120.0);
  EXPECT_NEAR(static_cast<double>(arrived.size()), 20'600.0, 100.0);
  EXPECT_NEAR(static_cast<double>(link.statistics().corrupted), 400.0, 80.0);
  EXPECT_GE(damaged + 10, link.statistics().corrupted * 99 / 100);
}

TEST(ImpairedLink, NothingPassesInAnOutage) {
  ImpairedLink link({.outage_every = 10s, .outage_for = 1s}, 7);
  for (const Arrived& one : run(link, 30'000)) EXPECT_LT(one.number % 10'000, 9'000U) << one.number;
  EXPECT_EQ(link.statistics().lost, 3'000U);
}

TEST(ImpairedLink, ALossDelaysAStreamByARoundTripAndKeepsItsOrder) {
  ImpairedLink link(
      {.delay = 50ms, .jitter = 20ms, .loss = 0.05, .corrupt = 1.0, .outage_every = 5s, .outage_for = 500ms}, 8);
  const auto arrived = run(link, 5000, 1ms, true);
  ASSERT_EQ(arrived.size(), 5000U);
  std::size_t late = 0;
  for (std::uint32_t i = 0; i < 5000; ++i) {
    EXPECT_EQ(arrived[i].number, i);
    EXPECT_EQ(arrived[i].bytes, numbered(i).bytes);
    if (arrived[i].at - i * 1ms > 71ms) ++late;
  }
  EXPECT_GT(late, 2500U);  // one loss holds up about a hundred segments
}

TEST(ImpairedLink, TheSameSeedGivesTheSameArrivalsAndAnotherSeedDoesNot) {
  const auto arrivals = [](std::uint64_t seed) {
    ImpairedLink link(profile_named("hostile")->down, seed);
    std::vector<std::pair<Nanoseconds, std::vector<std::byte>>> all;
    for (const Arrived& one : run(link, 3000)) all.emplace_back(one.at, one.bytes);
    return all;
  };
  EXPECT_EQ(arrivals(1), arrivals(1));
  EXPECT_NE(arrivals(1), arrivals(2));
}

TEST(ImpairedLink, ATraceChangesTheLinkOverTimeAndRepeats) {
  const Result<Trace> trace = parse_trace(
      "t_s,delay_ms,jitter_ms,loss_percent,rate_kbit_per_s\n"
      "0,10,0,0,100000\n1,40,0,0,100000\n2,10,0,0,0\n3,0,0,0,0\n",
      "t.csv");
  ASSERT_TRUE(trace.ok());
  ImpairedLink link({}, 9, *trace);
  const auto arrived = run(link, 6000);
  EXPECT_EQ(arrived.size(), 4000U);  // the third second of each three is an outage
  for (const Arrived& one : arrived) {
    const std::uint32_t within = one.number % 3000;
    ASSERT_LT(within, 2000U);
    EXPECT_NEAR(to_milliseconds(one.at - one.number * 1ms), within < 1000 ? 10.0 : 40.0, 0.1) << one.number;
  }
}

TEST(ImpairedLink, AWrongTraceIsRefusedWithItsLineIfOneIsWrong) {
  const std::string header = "t_s,delay_ms,jitter_ms,loss_percent,rate_kbit_per_s\n";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "line 1"},
      {"time,delay\n", "line 1"},
      {header, "the network trace has fewer than two rows"},
      {header + "0,1,1,1,1\n", "the network trace has fewer than two rows"},
      {header + "1,1,1,1,1\n2,1,1,1,1\n", "line 2"},
      {header + "0,1,1,1,1\n0,1,1,1,1\n", "line 3"},
      {header + "0,1,1,101,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,1,1,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,1,1,1,1,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,-1,1,1,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,nan,1,1,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,1e300,1,1,1\n1,1,1,1,1\n", "line 2"},
      {header + "0,1,1,1,1\n\n1,1,1,1,1\n", "line 3"},
      {std::string((1U << 20U) + 1, 'x'), "the network trace is larger than 1 MiB"},
  };
  for (const auto& [text, line] : wrong) {
    const Result<Trace> trace = parse_trace(text, "t.csv");
    ASSERT_FALSE(trace.ok()) << text;
    EXPECT_EQ(trace.error().what.find(line), 0U) << trace.error().what << " of: " << text.substr(0, 80);
  }
}

TEST(ImpairedLink, EachProfileIsFoundByNameAndAnotherNameListsThem) {
  for (const Profile& profile : profiles()) EXPECT_EQ(profile_named(profile.name)->name, profile.name);
  const auto unknown = profile_named("wifi");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().fix.find("lan, lte, satellite, hostile"), std::string::npos);
}

TEST(ImpairedLink, AChangeActsOnLaterPacketsAndOnTheQueue) {
  ImpairedLink link({.delay = 10ms, .rate_B_per_s = 12'000.0}, 1);  // 100 ms a packet
  link.send(0ms, numbered(0));
  link.send(0ms, numbered(1));
  link.change(0ms, {.delay = 50ms, .rate_B_per_s = 120'000.0});
  EXPECT_EQ(link.queued_B(0ms), 2 * kPacket_B) << "the queue keeps its bytes";
  link.send(0ms, numbered(2));
  ASSERT_EQ(link.next_arrival(), 80ms) << "20 ms for the queue, 10 ms for itself, 50 ms of delay";
  EXPECT_TRUE(link.receive(80ms));
  ASSERT_EQ(link.next_arrival(), 110ms) << "the first packet arrives as it would have before";
  link.change(80ms, {});
  link.send(80ms, numbered(3));
  EXPECT_EQ(link.next_arrival(), 80ms) << "an unlimited link has no queue";
}

TEST(ImpairedLink, AChangeOfLossBeginsAtOnce) {
  ImpairedLink link({}, 1);
  (void)run(link, 1000);
  EXPECT_EQ(link.statistics().lost, 0U);
  link.change(1000ms, {.loss = 1.0});
  for (std::uint32_t i = 0; i < 100; ++i) link.send(61s + i * 1ms, numbered(i));
  EXPECT_GT(link.statistics().lost, 90U);
}

}  // namespace
}  // namespace telepalp::impaired
