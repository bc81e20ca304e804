// The watchdog over the whole loop in virtual time: an input falls silent, and the force must end soon and smoothly.
// Tracker, surface and device have separate age limits; the force must end 50 ms after the limit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/loop/plane_snapshot.h"
#include "proto/words/latest_value.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::loop {
namespace {

using control::Phase;

constexpr int kTicksPerSecond = 2000;
constexpr int kTicksPerSample = 20;  // 100 Hz
constexpr int kFiftyMilliseconds = 100;
constexpr int kInContact = 4210;  // the hand presses; the tick lies between two samples and between two frames

enum Part : unsigned { kTracker = 1, kSurface = 2, kDevice = 4 };

/// A hand that waits a second above a level skin and then presses up and down, 10 to 50 mm deep, with inputs that can
/// fall silent. The frames H and K are equal here.
class Bench {
 public:
  explicit Bench(const control::ControlSettings& settings = {})
      : loop_({}, control::EncounteredController(settings, skin())), pair_({}, {}) {
    pair_.place({{0.0, 0.05, 0.0}}, {{0.0, 0.06, 0.0}});
  }

  unsigned silent = 0;        ///< Parts
  Nanoseconds clock_step{0};  ///< step of session time, from now on

  TickOut tick() {
    const SessionTime now = session_time(4'000'000'000'000 + std::int64_t{tick_} * 500'000) + clock_step;
    if (tick_ % kTicksPerFrame == 0 && (silent & kSurface) == 0) {
      surface_ = std::make_shared<PlaneSnapshot>(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), 1.0);
      surface_->captured = now;
      surfaces_.put({surface_, {}});
    }
    TickIn in{.now = now, .dt_s = kTick_s, .surface = surfaces_.take() ? &surfaces_.current() : nullptr};
    in.rearm = std::exchange(rearm_, false);
    if (tick_ % kTicksPerSample == 0 && (silent & kTracker) == 0) in.hand = {now, pair_.true_hand()};
    if ((silent & kDevice) == 0)
      reading_ = {.at = pair_.device(), .velocity = pair_.device_velocity(), .age_s = 0.0};
    else
      reading_.age_s += kTick_s;
    in.reading = reading_;
    const TickOut act = loop_.tick(in);
    pair_.step(act.force, {.at = {{0.0, wanted_height_m(), 0.0}}, .velocity = {}}, kTick_s);
    ++tick_;
    return act;
  }
  TickOut run(int ticks) {
    TickOut act;
    for (int i = 0; i < ticks; ++i) act = tick();
    return act;
  }
  void rearm() { rearm_ = true; }
  [[nodiscard]] double true_hand_m() const { return pair_.true_hand().m.y(); }

 private:
  [[nodiscard]] double wanted_height_m() const {
    const double pressing_s = (tick_ - kTicksPerSecond) * kTick_s;
    if (pressing_s < 0.0) return 0.06;
    return std::max(0.06 - 0.1 * pressing_s, -0.03 + 0.02 * std::sin(5.0 * pressing_s));
  }
  static effects::EffectBank skin() {
    effects::EffectBank bank;
    (void)bank.add(effects::Skin());
    return bank;
  }

  HapticLoop loop_;
  device::SimulatedPair pair_;
  LatestValue<TouchableSurface> surfaces_;
  std::shared_ptr<PlaneSnapshot> surface_;
  ports::DeviceReading reading_;
  int tick_ = 0;
  bool rearm_ = false;
};

struct Silence {
  const char* what;
  unsigned parts;
  double limit_s;  ///< the shortest limit of the silent inputs
  Phase becomes;
};
std::ostream& operator<<(std::ostream& out, const Silence& one) { return out << one.what; }

const control::AgeLimits kDefault;
const double kTrackerInContact_s = kDefault.tracker_in_contact_s + control::TransitionSettings{}.contact_release_s;
const Silence kSilences[] = {
    {"tracker", kTracker, kTrackerInContact_s, Phase::Released},
    {"surface", kSurface, kDefault.surface_s, Phase::Released},
    {"device", kDevice, kDefault.device_s, Phase::Faulted},
    {"tracker and surface", kTracker | kSurface, kDefault.surface_s, Phase::Released},
    {"everything at once", kTracker | kSurface | kDevice, kDefault.device_s, Phase::Faulted},
};

class Watchdog : public ::testing::TestWithParam<Silence> {};

/// The silence begins at many different ticks, so frames and samples have every age.
TEST_P(Watchdog, LetsGoWithinFiftyMillisecondsOfTheLimitAndGently) {
  int pressed = 0;
  for (int at = kInContact; at < kInContact + 2800; at += 97) {
    Bench bench;
    TickOut before = bench.run(at);
    if (before.force.N.norm() > 0.5) ++pressed;
    bench.silent = GetParam().parts;
    // At the beginning of the silence the newest frame or sample may already be old, so the force may end earlier.
    const int limit = static_cast<int>(GetParam().limit_s * kTicksPerSecond);
    double largest_step_N = 0.0;
    for (int tick = 0; tick < limit + kFiftyMilliseconds; ++tick) {
      const TickOut act = bench.tick();
      largest_step_N = std::max(largest_step_N, (act.force.N - before.force.N).norm());
      before = act;
    }
    EXPECT_LE(largest_step_N, 0.25) << "from tick " << at;
    for (int tick = 0; tick < kTicksPerSecond; ++tick) {
      const TickOut act = bench.tick();
      ASSERT_EQ(act.force.N.norm(), 0.0) << "from tick " << at << ", " << tick << " ticks later";
      ASSERT_EQ(act.control.phase, GetParam().becomes);
    }
  }
  EXPECT_GT(pressed, 15) << "most moments had a force to let go of";
}

TEST_P(Watchdog, ComesBackByItselfFromStaleInputsAndFromAFaultWhenRearmed) {
  Bench bench;
  bench.run(kInContact);
  bench.silent = GetParam().parts;
  bench.run(2 * kTicksPerSecond);
  bench.silent = 0;
  const Phase after = bench.run(kTicksPerSecond).control.phase;
  if (GetParam().becomes == Phase::Faulted) {
    EXPECT_EQ(after, Phase::Faulted) << "latched";
    bench.rearm();
  }
  EXPECT_FALSE(control::has_let_go(bench.run(kTicksPerSecond).control.phase));
}

INSTANTIATE_TEST_SUITE_P(Silences, Watchdog, ::testing::ValuesIn(kSilences), [](const auto& instance) {
  std::string name = instance.param.what;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

struct ClockStep {
  const char* what;
  Nanoseconds step;
  bool lets_go;  ///< the step is too large for slewing: another session's time
};
const ClockStep kClockSteps[] = {
    {"an hour back", -std::chrono::hours(1), true},
    {"an hour on", std::chrono::hours(1), true},
    {"a second back", -std::chrono::seconds(1), true},
    {"200 ms on, as after a stall", std::chrono::milliseconds(200), false},
    {"20 ms back", -std::chrono::milliseconds(20), false},
    {"20 ms on", std::chrono::milliseconds(20), false},
};

TEST(WatchdogClock, AStepOfSessionTimeNeitherJerksNorFreezesTheHand) {
  for (const ClockStep& c : kClockSteps) {
    Bench bench;
    TickOut before = bench.run(kInContact);  // at a tick without a sample or a frame
    ASSERT_GT(before.force.N.norm(), 0.5);
    bench.clock_step = c.step;
    bool let_go = false;
    double largest_step_N = 0.0;
    for (int tick = 0; tick < 2 * kTicksPerSecond; ++tick) {
      const TickOut act = bench.tick();
      ASSERT_TRUE(act.force.N.allFinite()) << c.what;
      let_go = let_go || control::has_let_go(act.control.phase);
      largest_step_N = std::max(largest_step_N, (act.force.N - before.force.N).norm());
      before = act;
    }
    EXPECT_EQ(let_go, c.lets_go) << c.what;
    EXPECT_LE(largest_step_N, 0.25) << c.what;
    EXPECT_FALSE(control::has_let_go(before.control.phase)) << c.what << ": it is back after two seconds";
    EXPECT_NEAR(before.sample.hand[1], bench.true_hand_m(), 0.01) << c.what << ": the hand is followed, not frozen";
  }
}

TEST(WatchdogClock, AfterAStepBackTheWatchdogStillSeesSilence) {
  for (const unsigned part : {kTracker, kSurface}) {
    Bench bench;
    bench.run(kInContact);
    bench.clock_step = -std::chrono::hours(1);
    bench.silent = part;
    bench.run(static_cast<int>(0.1 * kTicksPerSecond));
    for (int tick = 0; tick < 3 * kTicksPerSecond; ++tick) ASSERT_EQ(bench.tick().force.N.norm(), 0.0) << part;
  }
}

TEST(WatchdogLimits, AreTheScenes) {
  control::ControlSettings settings;
  settings.ages = {.tracker_s = 0.05, .tracker_in_contact_s = 0.05, .surface_s = 0.2, .device_s = 0.02};
  settings.transitions.contact_release_s = 0.02;
  const std::pair<Part, double> limits[] = {{kTracker, 0.05}, {kSurface, 0.2}, {kDevice, 0.02}};
  for (const auto& [part, limit_s] : limits) {
    Bench bench(settings);
    ASSERT_GT(bench.run(kInContact).force.N.norm(), 0.5);
    bench.silent = part;
    const int limit = static_cast<int>(limit_s * kTicksPerSecond);
    EXPECT_GT(bench.run(limit / 2).force.N.norm(), 0.0) << part << ": not before";
    bench.run(limit - limit / 2 + kFiftyMilliseconds);
    EXPECT_EQ(bench.tick().force.N.norm(), 0.0) << part;
  }
}

}  // namespace
}  // namespace telepalp::loop
