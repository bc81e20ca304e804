// A played session crosses an impaired network, in virtual time, and visitors change that network by commands.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <functional>

#include "server/playback/impaired_path.h"
#include "server/playback/network_command.h"
#include "server/playback/session_network.h"

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kBegin = session_time(1'700'000'000'000'000'000);

wire::Message message(const wire::Topic& topic, SessionTime at, std::uint64_t sequence, bool key_frame = true,
                      std::size_t bytes = 30'000) {
  return {.topic = topic,
          .published = at,
          .payload = std::make_shared<const std::string>(bytes, 'x'),
          .sequence = sequence,
          .key_frame = key_frame};
}

struct Arrival {
  wire::Message message;
  SessionTime at;
};

/// Ten seconds of a session: a depth image and an event each 33 ms, in steps of 1 ms of virtual time; then 2 s more.
/// `group`: number of depth images from key frame to key frame.
std::vector<Arrival> play(
    ImpairedPath& path, std::uint64_t group = 1, const std::function<void(int ms)>& each_ms = [](int) {}) {
  std::vector<Arrival> arrivals;
  std::uint64_t number = 0;
  for (int ms = 0; ms < 12'000; ++ms) {
    const SessionTime now = kBegin + std::chrono::milliseconds(ms);
    each_ms(ms);
    if (ms < 10'000 && ms % 33 == 0) {
      ++number;
      path.send(now, message(wire::kCameraDepth, now, number, (number - 1) % group == 0));
      path.send(now, message(wire::kStationEvents, now, number, true, 2000));
    }
    for (wire::Message& arrived : path.receive(now)) arrivals.push_back({std::move(arrived), now});
  }
  return arrivals;
}

std::vector<Arrival> on(const wire::Topic& topic, const std::vector<Arrival>& all) {
  std::vector<Arrival> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
               [&](const Arrival& one) { return one.message.topic.name == topic.name; });
  return chosen;
}

constexpr std::size_t kSent = 304;  // images, and events

impaired::Profile alike(const impaired::Impairment& either_way) {
  return {.name = "test", .down = either_way, .up = either_way};
}

TEST(ImpairedPath, AQuietNetworkDeliversAllMessagesWithTheirStamps) {
  ImpairedPath path(kBegin, alike({.delay = 1ms}), 1);
  const auto arrivals = play(path);
  ASSERT_EQ(on(wire::kCameraDepth, arrivals).size(), kSent);
  ASSERT_EQ(on(wire::kStationEvents, arrivals).size(), kSent);
  for (const Arrival& arrival : arrivals) {
    EXPECT_GE(arrival.at - arrival.message.published, 1ms);
    EXPECT_LE(arrival.at - arrival.message.published, 40ms);
    EXPECT_EQ(arrival.message.payload->front(), 'x');
  }
}

TEST(ImpairedPath, DelayIsWhatImagesAndEventsTakeMoreAndAChangeActsAtOnce) {
  ImpairedPath path(kBegin, alike({.delay = 1ms}), 1);
  const auto arrivals = play(path, 1, [&](int ms) {
    if (ms == 5000) path.change(kBegin + 5000ms, alike({.delay = 200ms}));
  });
  for (const Arrival& arrival : arrivals) {
    const Nanoseconds since_begin = arrival.message.published - kBegin;
    const Nanoseconds took = arrival.at - arrival.message.published;
    EXPECT_LT(took, since_begin < 4900ms ? 100ms : 1s);
    EXPECT_GE(took, since_begin < 5000ms ? 1ms : 200ms);
  }
  EXPECT_GT(on(wire::kCameraDepth, arrivals).size(), kSent * 9 / 10) << "delay alone loses next to nothing";
}

TEST(ImpairedPath, LossIsRepairedWhereTimeAllowsAndEventsAllArriveInOrder) {
  ImpairedPath path(kBegin, alike({.delay = 10ms, .loss = 0.05, .burst_packets = 2.0}), 1);
  const auto arrivals = play(path);
  EXPECT_GT(on(wire::kCameraDepth, arrivals).size(), kSent * 9 / 10);
  EXPECT_GT(path.statistics().lost, 100U);
  const auto events = on(wire::kStationEvents, arrivals);
  ASSERT_EQ(events.size(), kSent) << "TCP loses nothing";
  for (std::size_t at = 1; at < events.size(); ++at)
    EXPECT_EQ(events[at].message.sequence, events[at - 1].message.sequence + 1);
}

TEST(ImpairedPath, APredictedImageArrivesOnlyAfterTheOneBeforeIt) {
  ImpairedPath path(kBegin, alike({.delay = 60ms, .loss = 0.3, .burst_packets = 8.0}), 1);
  const auto images = on(wire::kCameraDepth, play(path, 12));
  ASSERT_GT(images.size(), 12U);
  EXPECT_LT(images.size(), kSent) << "the case loses images, or it shows nothing";
  std::uint64_t last = 0;
  for (const Arrival& image : images) {
    EXPECT_GT(image.message.sequence, last);
    EXPECT_TRUE(image.message.key_frame || image.message.sequence == last + 1) << image.message.sequence;
    last = image.message.sequence;
  }
}

TEST(ImpairedPath, ANarrowNetworkDropsImagesAndNotTime) {
  ImpairedPath path(kBegin, alike({.delay = 5ms, .rate_B_per_s = 375'000.0, .queue_B = 64 * 1024}), 1);
  const auto images = on(wire::kCameraDepth, play(path));
  EXPECT_LT(images.size(), kSent / 2) << "the images alone take 0.9 MB/s";
  EXPECT_GT(images.size(), 10U);
  for (const Arrival& image : images) EXPECT_LT(image.at - image.message.published, 1500ms);
}

TEST(ImpairedPath, ItsEndGivesTheEventsThatWereOnTheWay) {
  ImpairedPath path(kBegin, alike({.delay = 300ms}), 1);
  for (std::uint64_t number = 1; number <= 3; ++number)
    path.send(kBegin, message(wire::kStationEvents, kBegin, number));
  const auto rest = path.end();
  ASSERT_EQ(rest.size(), 3U);
  EXPECT_EQ(rest.back().sequence, 3U);
}

TEST(ImpairedPath, MessagesThatWaitTakeBoundedMemory) {
  ImpairedPath path(kBegin, alike({.delay = 1ms, .rate_B_per_s = 12'500.0, .queue_B = 4096}), 1);
  for (std::uint64_t number = 1; number <= 100; ++number)
    path.send(kBegin, message(wire::kStationEvents, kBegin, number, true, 1'000'000));
  EXPECT_EQ(path.end().size(), 8U);
}

TEST(NetworkCommand, AProfileThenNumbersOfItsOwnThenNone) {
  const auto apply = [](const ChosenNetwork& chosen, const char* json) {
    const auto command = read_network_command(json);
    EXPECT_TRUE(command) << to_string(command.error());
    return *after_command(chosen, *command);
  };
  const ChosenNetwork lte = apply({}, R"({"profile": "lte"})");
  EXPECT_TRUE(lte.impairs());
  EXPECT_EQ(lte.network.down.delay, 25ms);
  const ChosenNetwork slower = apply(lte, R"({"delay_ms": 80.5, "loss_percent": 2})");
  EXPECT_EQ(slower.profile, "lte");
  EXPECT_TRUE(slower.changed);
  EXPECT_EQ(slower.network.down.delay, 80'500us);
  EXPECT_EQ(slower.network.up.loss, 0.02);
  EXPECT_EQ(slower.network.down.burst_packets, 3.0) << "the profile's";
  EXPECT_FALSE(apply(slower, R"({"profile": "none"})").impairs());
  EXPECT_TRUE(apply({}, R"({"delay_ms": 10})").impairs());
  EXPECT_DOUBLE_EQ(state_of(slower).rate_mbit_per_s(), 40.0);
}

TEST(NetworkCommand, WrongValuesAndProfilesAreNamed) {
  for (const char* wrong : {"", "[]", R"({"delay_ms": -1})", R"({"delay_ms": 1001})", R"({"delay_ms": "NaN"})",
                            R"({"jitter_ms": 501})", R"({"loss_percent": 51})", R"({"burst_packets": 0})",
                            R"({"rate_Mbit_per_s": 0.05})", R"({"rate_Mbit_per_s": 1e9})", R"({"speed": 1})"})
    EXPECT_FALSE(read_network_command(wrong)) << wrong;
  msg::NetworkCommand command;
  command.set_profile("moon");
  const auto unknown = after_command({}, command);
  ASSERT_FALSE(unknown);
  EXPECT_NE(to_string(unknown.error()).find("hostile, none"), std::string::npos);
}

TEST(SessionNetwork, PassesOnAtOnceUntilItIsToldToImpair) {
  boost::asio::io_context io;
  const auto clock = wire::SessionClock::anchored_to_wall_clock();
  std::vector<wire::Message> published;
  SessionNetwork network(io, clock, [&](wire::Message one) { published.push_back(std::move(one)); });
  network.send(message(wire::kCameraDepth, clock.now(), 0));
  EXPECT_EQ(published.size(), 1U);
  ASSERT_TRUE(network.apply(R"({"profile": "satellite"})"));
  network.send(message(wire::kCameraDepth, clock.now(), 0));
  network.send(message(wire::kStationEvents, clock.now(), 0));
  EXPECT_EQ(published.size(), 1U) << "both are on the way";
  ASSERT_TRUE(network.apply(R"({"profile": "none"})"));
  EXPECT_EQ(published.size(), 2U) << "the event arrives, the image is lost";
  EXPECT_EQ(network.state().profile(), "none");
  network.send(message(wire::kCameraDepth, clock.now(), 0, false));
  EXPECT_EQ(published.size(), 2U) << "an image predicted from the lost one cannot be decoded";
  network.send(message(wire::kCameraDepth, clock.now(), 0, true));
  EXPECT_EQ(published.size(), 3U);
}

TEST(SessionNetwork, ItsTimerDeliversWhatIsOnTheWayAndCountsIt) {
  boost::asio::io_context io;
  const auto clock = wire::SessionClock::anchored_to_wall_clock();
  std::size_t published = 0;
  Nanoseconds age{0};
  const SessionTime sent = clock.now();
  SessionNetwork network(io, clock, [&](const wire::Message& one) {
    ++published;
    age = one.published - sent;
  });
  ASSERT_TRUE(network.apply(R"({"delay_ms": 20})"));
  network.send(message(wire::kCameraDepth, sent, 0));
  const auto limit = std::chrono::steady_clock::now() + 20s;
  while (published == 0 && std::chrono::steady_clock::now() < limit) io.run_one_for(50ms);
  EXPECT_EQ(published, 1U);
  EXPECT_GE(age, 20ms) << "it is published when it arrives";
  EXPECT_EQ(network.state().images_arrived(), 1U);
  network.stop();
}

TEST(SessionNetwork, AWrongCommandChangesNothing) {
  boost::asio::io_context io;
  SessionNetwork network(io, wire::SessionClock::anchored_to_wall_clock(), [](const wire::Message&) {});
  const std::string before = network.state().SerializeAsString();
  EXPECT_FALSE(network.apply(R"({"loss_percent": 99})"));
  EXPECT_FALSE(network.apply(R"({"profile": "moon", "delay_ms": 5})"));
  EXPECT_EQ(network.state().SerializeAsString(), before);
}

}  // namespace
}  // namespace telepalp::playback
