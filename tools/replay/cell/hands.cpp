#include "tools/replay/cell/hands.h"

#include <algorithm>
#include <array>
#include <span>

#include "haptic_station/loop/simulated_rig.h"
#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {
namespace {

constexpr double kRestHeight_m = 0.10;  // as in the station

/// Heights below zero are the person's targets inside the body; the arm yields, so the skin is indented less.
constexpr auto kExamination = std::to_array<device::Waypoint>({
    {1.0, 0.0, 0.07, 0.0},  // above the waiting plane
    {0.6, 0.0, 0.02, 0.0},  // through the plane
    {0.8, 0.0, -0.035, 0.0},
    {2.0, 0.0, -0.035, 0.0},
    {0.8, 0.03, -0.035, 0.0},
    {1.4, -0.03, -0.035, 0.0},
    {0.9, 0.0, -0.035, 0.02},
    {0.5, 0.0, -0.035, 0.0},
    {1.0, 0.0, 0.07, 0.0},
    {1.0, 0.0, 0.07, 0.0},
});

/// Short contacts: the controller begins and ends each of them.
constexpr auto kTaps = std::to_array<device::Waypoint>({
    {1.0, 0.0, 0.07, 0.0},
    {0.6, 0.0, 0.02, 0.0},
    {0.2, 0.0, -0.03, 0.0},
    {0.2, 0.0, 0.02, 0.0},
    {0.3, 0.02, 0.02, 0.01},
    {0.15, 0.02, -0.04, 0.01},
    {0.15, 0.02, 0.02, 0.01},
    {0.3, -0.03, 0.02, 0.0},
    {0.4, -0.03, -0.035, 0.0},
    {0.1, -0.03, 0.02, 0.0},
    {0.7, 0.0, 0.07, 0.0},
});

constexpr auto kSearch = std::to_array<device::Waypoint>({
    {1.0, 0.0, 0.07, 0.0},
    {0.6, 0.0, 0.02, 0.0},
    {0.6, 0.0, -0.02, 0.0},
    {1.2, 0.03, -0.03, 0.02},
    {1.2, -0.03, -0.02, 0.03},
    {1.2, -0.03, -0.045, -0.03},
    {1.2, 0.03, -0.025, -0.02},
    {1.2, 0.0, -0.04, 0.03},
    {0.6, 0.0, -0.01, 0.0},
    {1.0, 0.0, 0.07, 0.0},
});

std::span<const device::Waypoint> waypoints(HandScript script, device::Trial trial) noexcept {
  switch (script) {
    case HandScript::Tap:
      return kTaps;
    case HandScript::Search:
      return kSearch;
    case HandScript::Scene:
      return device::waypoints(trial);
    case HandScript::Examine:
      return kExamination;
  }
  return kExamination;
}

constexpr Nanoseconds kHandPeriod{10'000'000};  // a tracker's samples come at 100 Hz

/// Repeats a recording tick by tick.
class RecordedRig final : public ports::Rig {
 public:
  explicit RecordedRig(const RecordedHand& recorded) noexcept : recorded_(recorded) {}

  [[nodiscard]] ports::DeviceReading read() noexcept override {
    const RecordedInstant at = instant(now_);
    const RecordedInstant before = instant(now_ - kTick);
    return {.at = at.device, .velocity = {(at.device.m - before.device.m) / to_seconds(kTick)}, .age_s = 0.0};
  }
  [[nodiscard]] std::optional<ports::HandSample> hand(SessionTime now) noexcept override {
    if (now_ < next_sample_) return std::nullopt;
    next_sample_ = now_ + kHandPeriod;
    return ports::HandSample{.at = now, .hand = instant(now_).hand};
  }
  void apply(const Wrench<HapticBase>&, const ports::SurfaceContact&, double) noexcept override { now_ += kTick; }

 private:
  [[nodiscard]] RecordedInstant instant(SessionTime at) const noexcept {
    const auto after = std::lower_bound(recorded_.begin(), recorded_.end(), at,
                                        [](const RecordedInstant& one, SessionTime then) { return one.at < then; });
    if (after == recorded_.begin()) return recorded_.front();
    if (after == recorded_.end()) return recorded_.back();
    const RecordedInstant& before = *std::prev(after);
    const double share = to_seconds(at - before.at) / to_seconds(after->at - before.at);
    return {.at = at,
            .device = {before.device.m + share * (after->device.m - before.device.m)},
            .hand = {before.hand.m + share * (after->hand.m - before.hand.m)}};
  }

  const RecordedHand& recorded_;
  SessionTime now_ = kBegin;
  SessionTime next_sample_ = kBegin;
};

}  // namespace

std::unique_ptr<ports::Rig> scripted_hand(HandScript script, device::Trial trial, std::uint64_t seed) {
  return std::make_unique<loop::SimulatedRig>(
      loop::SimulatedRig::Settings{
          .device = {}, .hand = {}, .tracker = {}, .rest = {{0.0, kRestHeight_m, 0.0}}, .seed = seed},
      device::ScriptedIntention(waypoints(script, trial), Point<HapticBase>{}));
}

std::unique_ptr<ports::Rig> recorded_hand(const RecordedHand& recorded) {
  return std::make_unique<RecordedRig>(recorded);
}

}  // namespace telepalp::replay
