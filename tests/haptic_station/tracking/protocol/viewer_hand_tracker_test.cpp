#include "haptic_station/tracking/protocol/viewer_hand_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace telepalp::tracking {
namespace {

using namespace std::chrono_literals;
using Taken = ViewerHandTracker::Taken;
using Clock = ViewerHandTracker::Clock;

msg::ViewerHand from(std::uint64_t viewer, std::chrono::microseconds sampled) {
  msg::ViewerHand hand;
  hand.set_viewer(viewer);
  hand.set_sampled_us(static_cast<std::uint64_t>(sampled.count()));
  return hand;
}

/// In these tests session time equals the steady clock.
SessionTime session(Clock::time_point at) { return SessionTime(at.time_since_epoch()); }

const Point<HapticBase> kNear{{0.0, 0.05, 0.0}};

TEST(ViewerHandTracker, GivesEachSampleOnceAtTheTimeThatTheViewerTookIt) {
  ViewerHandTracker hand;
  const auto began = Clock::now();
  EXPECT_FALSE(hand.sample(session(began), {}));
  EXPECT_EQ(hand.hear(from(1, 5s), kNear, began), Taken::Followed);
  EXPECT_TRUE(hand.sample(session(Clock::now()), {}));
  EXPECT_FALSE(hand.sample(session(Clock::now()), {})) << "silence, which the watchdog sees";
  // A connection that was blocked for 80 ms delivers a sample that is 80 ms old, with its true age.
  EXPECT_EQ(hand.hear(from(1, 5s + 20ms), kNear, began + 100ms), Taken::Followed);
  const auto late = hand.sample(session(Clock::now()), {});
  ASSERT_TRUE(late);
  EXPECT_NEAR(to_seconds(late->at - session(began)), 0.020, 0.001);
}

TEST(ViewerHandTracker, AHandThatPassesToAnotherViewerIsInvalidFor300ms) {
  ViewerHandTracker hand;
  const auto began = Clock::now();
  EXPECT_EQ(hand.hear(from(1, 0us), kNear, began), Taken::Followed);
  EXPECT_EQ(hand.hear(from(2, 0us), kNear, began + 100ms), Taken::Passing);
  EXPECT_EQ(hand.hear(from(1, 200ms), kNear, began + 200ms), Taken::Followed);
  EXPECT_EQ(hand.hear(from(2, 0us), kNear, began + 499ms), Taken::Passing);
  EXPECT_EQ(hand.hear(from(2, 0us), kNear, began + 501ms), Taken::Followed);
  EXPECT_EQ(hand.hear(from(1, 600ms), kNear, began + 600ms), Taken::Passing);
}

struct HardCase {
  const char* what;
  std::uint64_t sampled_us;
  Point<HapticBase> at;
  Taken taken;
};
const double kNaN = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();
const HardCase kHardCases[] = {
    {"at the rim of the reach", 1, {{0.0, 0.0, 0.5}}, Taken::Followed},
    {"beyond the reach", 1, {{0.0, 0.0, 0.51}}, Taken::OutOfReach},
    {"not a number", 1, {{kNaN, 0.0, 0.0}}, Taken::OutOfReach},
    {"infinite", 1, {{0.0, -kInfinity, 0.0}}, Taken::OutOfReach},
    {"a clock that stands at zero", 0, {{0.0, 0.0, 0.0}}, Taken::Followed},
    {"the largest clock that fits the wire",
     std::numeric_limits<std::uint64_t>::max(),
     {{0.0, 0.0, 0.0}},
     Taken::Followed},
};

TEST(ViewerHandTracker, HardCasesNeitherBreakTheClockNorTheHand) {
  for (const HardCase& c : kHardCases) {
    ViewerHandTracker hand;
    const auto now = Clock::now();
    msg::ViewerHand message = from(1, 0us);
    message.set_sampled_us(c.sampled_us);
    EXPECT_EQ(hand.hear(message, c.at, now), c.taken) << c.what;
    const auto sample = hand.sample(session(Clock::now()), {});
    EXPECT_EQ(sample.has_value(), c.taken == Taken::Followed) << c.what;
    if (sample) {
      EXPECT_LE(std::abs(to_seconds(sample->at - session(now))), 0.1) << c.what;
    }
  }
}

TEST(ViewerHandTracker, AClockThatStepsIsANewClockAndNeverTheFuture) {
  ViewerHandTracker hand;
  const auto began = Clock::now();
  EXPECT_EQ(hand.hear(from(1, 3600s), kNear, began), Taken::Followed);
  EXPECT_TRUE(hand.sample(session(Clock::now()), {}));
  for (const auto sampled : {std::chrono::microseconds(10s), std::chrono::microseconds(7200s)}) {
    EXPECT_EQ(hand.hear(from(1, sampled), kNear, began + 50ms), Taken::Followed);
    const auto sample = hand.sample(session(Clock::now()), {});
    ASSERT_TRUE(sample);
    EXPECT_NEAR(to_seconds(sample->at - session(began)), 0.05, 0.005);
  }
}

}  // namespace
}  // namespace telepalp::tracking
