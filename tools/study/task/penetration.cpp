#include "tools/study/task/penetration.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace telepalp::study {
namespace {

using Eigen::Vector3d;
constexpr double kTick_s = 0.0005;
constexpr auto kWindow = static_cast<std::size_t>(kStoppedOver_s / kTick_s);
constexpr double kSeenPast_m = 0.001;  // a needle is seen to have passed a layer this far beyond it

/// The arm in the plane of the tool: a mass on a spring and a damper to its far end.
class Arm {
 public:
  Arm(const Operator& person, const Vector3d& at_m) noexcept : person_(person), hand_m_(at_m), end_m_(at_m) {}
  void step(const Vector3d& end_m, const Vector3d& force_N) noexcept {
    const double damping = 2.0 * person_.arm_damping * std::sqrt(person_.arm_N_per_m * person_.arm_kg);
    const Vector3d end_velocity = (end_m - end_m_) / kTick_s;
    end_m_ = end_m;
    const Vector3d push_N = person_.arm_N_per_m * (end_m_ - hand_m_) + damping * (end_velocity - velocity_);
    velocity_ += kTick_s / person_.arm_kg * (push_N + force_N);
    hand_m_ += kTick_s * velocity_;
  }
  [[nodiscard]] const Vector3d& hand_m() const noexcept { return hand_m_; }

 private:
  const Operator& person_;
  Vector3d hand_m_;
  Vector3d end_m_;
  Vector3d velocity_ = Vector3d::Zero();
};

/// Where the tip was over the last 0.1 s.
class StopRule {
 public:
  [[nodiscard]] bool stopped(const Vector3d& tip_m) noexcept {
    const std::size_t at = count_ % kWindow;
    const bool still = count_ >= kWindow && (tip_m - before_[at]).norm() < kStoppedMove_m;
    before_[at] = tip_m;
    ++count_;
    return still;
  }

 private:
  std::array<Vector3d, kWindow> before_{};
  std::size_t count_ = 0;
};

}  // namespace

Outcome penetrate(const Penetration& one, Learned& learned, device::Random& random) noexcept {
  Decisions decisions(one.person, one.condition, learned, random);
  tissue::LayeredTissue tissue(one.tissue);
  HeldTool& tool = one.tool;
  Arm arm(one.person, tool.on_the_way_m(0.0));
  StopRule rule;
  Outcome out;
  Vector3d contact_m = Vector3d::Zero();
  Vector3d along = -Vector3d::UnitY();
  bool touched = false;
  double way_m = 0.0;
  double before_N = 0.0;
  Vector3d needle_N = Vector3d::Zero();  // on the hand
  tissue.begin({.tip_m = tool.tip_m(), .axis = tool.axis()});
  for (int tick = 0; tick < static_cast<int>(kLongest_s / kTick_s); ++tick) {
    out.seconds = tick * kTick_s;
    const double depth_m = -tool.tip_m().y();
    const Perceived sensed{.depth_m = depth_m,
                           .hand_force_N = needle_N.norm(),
                           .layer_passed = out.through && depth_m > out.depth_at_puncture_m + kSeenPast_m,
                           .punctured = out.through};
    way_m += kTick_s * decisions.speed_m_per_s(sensed, kTick_s);
    const Vector3d tremor_m(decisions.tremor_m(out.seconds, 0), decisions.tremor_m(out.seconds, 1), 0.0);
    const Vector3d shown_N =
        feels(one.condition) ? Vector3d(needle_N + tool.guide_force_N()) : Vector3d(Vector3d::Zero());
    arm.step(tool.on_the_way_m(way_m) + tremor_m, shown_N);
    tool.step(arm.hand_m(), kTick_s);
    needle_N = tool.hand_force_N(tissue.step({.tip_m = tool.tip_m(), .axis = tool.axis()}, kTick_s).force_N);
    out.most_hand_N = std::max(out.most_hand_N, needle_N.norm());
    const tissue::LayerState sac = tissue.layer(kSac).state;
    if (!touched && sac != tissue::LayerState::Removed) {
      touched = true;
      contact_m = tool.tip_m();
      along = tool.axis();
    }
    if (!out.through && sac == tissue::LayerState::Inserted) {
      out.through = true;
      out.depth_at_puncture_m = -tool.tip_m().y();
      out.hand_drop_N = before_N;
      learned.add(decisions.sensed_depth_m(out.depth_at_puncture_m));
    }
    if (!out.through) before_N = tool.hand_force_N(tissue.layer(kSac).force_N).norm();
    if (touched) out.deepest_m = std::max(out.deepest_m, (tool.tip_m() - contact_m).dot(along));
    if (rule.stopped(tool.tip_m()) && out.through) {
      out.stopped = true;
      break;
    }
  }
  out.noticed = decisions.noticed();
  if (touched) out.overshoot_m = (tool.tip_m() - contact_m).dot(along);
  return out;
}

}  // namespace telepalp::study
