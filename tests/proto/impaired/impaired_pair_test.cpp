#include "proto/impaired/impaired_pair.h"

#include <gtest/gtest.h>

namespace telepalp::impaired {
namespace {

using namespace std::chrono_literals;

constexpr SessionTime kBegin{100s};
constexpr Nanoseconds kStep = 1ms;
const Profile kSlow{.name = "slow", .down = {.delay = 40ms}, .up = {.delay = 10ms}};

link::DatagramLinkSettings session(std::uint32_t number) {
  return {.seal = {.session = {}, .number = number, .cipher = link::Cipher::Aes256Gcm}};
}

link::Frame frame(std::uint32_t number, SessionTime captured) {
  return {.channel = 0, .number = number, .captured = captured, .bytes = std::vector<std::byte>(5000, std::byte{7})};
}

/// Runs the pair from `now` until `until` and returns when a frame was complete at the client.
std::vector<SessionTime> run(ImpairedPair& pair, SessionTime& now, SessionTime until,
                             const ImpairedPair::OnSegment& on_segment = {}) {
  std::vector<SessionTime> complete;
  for (; now < until; now += kStep) {
    pair.deliver(now, on_segment);
    (void)pair.transmit_from_server(now);
    (void)pair.transmit_from_client(now);
    while (pair.client().take(now)) complete.push_back(now);
  }
  return complete;
}

TEST(ImpairedPair, AFrameIsCompleteAfterTheDelayOfItsDirectionAlone) {
  ImpairedPair pair(kBegin, kSlow, 1, session(1));
  SessionTime now = kBegin;
  (void)pair.server().offer(frame(0, now));
  const std::vector<SessionTime> complete = run(pair, now, kBegin + 200ms);
  ASSERT_EQ(complete.size(), 1U);
  EXPECT_GE(complete[0] - kBegin, 40ms);
  EXPECT_LT(complete[0] - kBegin, 50ms);
}

TEST(ImpairedPair, ANewLinkSessionRefusesWhatIsOnTheWayAndGoesOn) {
  ImpairedPair pair(kBegin, kSlow, 1, session(1));
  SessionTime now = kBegin;
  (void)pair.server().offer(frame(0, now));
  EXPECT_TRUE(run(pair, now, kBegin + 20ms).empty());
  pair.begin_link_session(session(2));
  EXPECT_TRUE(run(pair, now, kBegin + 200ms).empty()) << "datagrams of the session before are refused";
  (void)pair.server().offer(frame(0, now));
  EXPECT_EQ(run(pair, now, kBegin + 400ms).size(), 1U);
}

TEST(ImpairedPair, AChangeActsOnBothDirectionsAndTheEarliestArrivalIsDue) {
  ImpairedPair pair(kBegin, kSlow, 1, session(1));
  pair.change(kBegin, {.name = "slower", .down = {.delay = 90ms}, .up = {.delay = 10ms}});
  (void)pair.server().offer(frame(0, kBegin));
  (void)pair.transmit_from_server(kBegin);
  pair.down().send(pair.since_begin(kBegin + 1ms), {.bytes = std::vector<std::byte>(100), .stream = true});
  const std::optional<SessionTime> due = pair.due(kBegin + 1ms);
  ASSERT_TRUE(due);
  EXPECT_LE(*due, kBegin + 90ms);
  std::size_t segment_B = 0;
  SessionTime now = kBegin + 1ms;
  const auto complete = run(pair, now, kBegin + 200ms, [&](std::size_t bytes) { segment_B += bytes; });
  EXPECT_EQ(segment_B, 100U);
  ASSERT_EQ(complete.size(), 1U);
  EXPECT_GE(complete[0] - kBegin, 90ms);
}

}  // namespace
}  // namespace telepalp::impaired
