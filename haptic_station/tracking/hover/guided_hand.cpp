#include "haptic_station/tracking/hover/guided_hand.h"

#include <algorithm>
#include <cmath>

namespace telepalp::tracking {
namespace {

using Eigen::Vector3d;

constexpr double kLongestStep_s = 0.05;  // after a longer pause of the browser the hand does not jump
constexpr double kDown_m_per_s = 0.12;   // of a hand that comes down to press
constexpr double kArrived_m = 0.015;     // horizontal distance of hand and device at which a pressing hand comes down
constexpr double kDown_m = 0.003;        // distance from the wanted height at which it has come down

constexpr double kSlows_s = 0.1;  // time constant of the arrival
constexpr double kFastest_m_per_s2 =
    6.0;  // acceleration; above kFastest_m_per_s / kSlows_s, so that the hand does not overshoot

constexpr double kAhead_m = 0.10;      // the device rises over whatever is seen this near
constexpr double kNear_m = 0.05;       // the hand crosses a place only when the device is over all that is this near
constexpr double kClearance_m = 0.02;  // of the waiting device, as PlaneSettings::clearance_m
constexpr double kFull_m = 0.018;      // clearance of the device from which the hand has its full speed
constexpr double kLeast_m = 0.010;     // clearance of the device at which the hand waits for it to rise
constexpr double kHand_m = 0.06;       // clearance of the hand: it is well above the device, and does not press it down
constexpr double kLeash_m = 0.06;      // the hand waits for a device that is this far behind
constexpr double kLoose_m = 0.03;      // up to this distance it does not

double share(double value, double from, double to) noexcept {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

Vector3d at_most(const Vector3d& v, double most) noexcept {
  const double length = v.norm();
  return length > most ? Vector3d(v * (most / length)) : v;
}

double across_m(const Vector3d& v) noexcept { return std::hypot(v.x(), v.z()); }

/// Height [m] of the highest skin near hand and device, which both must clear.
double highest_around(const SkinHeights& skin, const Point<HapticBase>& hand,
                      const Point<HapticBase>& device) noexcept {
  return std::max(skin.highest(hand, kAhead_m), skin.highest(device, kAhead_m));
}

}  // namespace

GuidedHand::Guided GuidedHand::follow(const Wanted& wanted, const Point<HapticBase>& device, const SkinHeights& skin,
                                      double dt_s) noexcept {
  if (!begun_) at_ = device;
  begun_ = true;
  choose_way(wanted, device);
  const double step_s = std::clamp(dt_s, 0.0, kLongestStep_s);
  if (way_ == Way::Flies)
    fly(wanted, device, skin, step_s);
  else
    go(wanted.at.m - at_.m, step_s);
  const double highest_m = highest_around(skin, at_, device);
  const bool demands = way_ == Way::Flies && std::isfinite(highest_m);
  return {.hand = at_, .wait_at_m = demands ? std::optional(highest_m + kClearance_m) : std::nullopt};
}

void GuidedHand::choose_way(const Wanted& wanted, const Point<HapticBase>& device) noexcept {
  const Vector3d left_m = wanted.at.m - at_.m;
  hovered_ = hovered_ || wanted.hovers;
  if (wanted.hovers)
    way_ = Way::Flies;
  else if (way_ == Way::Flies && std::max(across_m(left_m), across_m(device.m - at_.m)) < kArrived_m)
    way_ = Way::ComesDown;
  else if (way_ == Way::ComesDown && std::abs(left_m.y()) < kDown_m)
    way_ = Way::Follows;
}

/// One step to a pressed place, which is straight for a hand that a headset tracks.
void GuidedHand::go(const Vector3d& way_m, double dt_s) noexcept {
  if (!hovered_) {
    at_.m += at_most(way_m, kFastest_m_per_s * dt_s);
    return;
  }
  accelerate(way_m, way_ == Way::ComesDown ? kDown_m_per_s : kFastest_m_per_s, dt_s);
  at_.m += m_per_s_ * dt_s;
}

/// One step over the patient. The hand stops at once where the device is too low or too far behind.
void GuidedHand::fly(const Wanted& wanted, const Point<HapticBase>& device, const SkinHeights& skin,
                     double dt_s) noexcept {
  Vector3d way_m = wanted.at.m - at_.m;
  way_m.y() = std::max(wanted.at.m.y(), highest_around(skin, at_, device) + kHand_m) - at_.m.y();
  accelerate(way_m, kFastest_m_per_s, dt_s);
  const Vector3d next_m = at_.m + m_per_s_ * dt_s;
  const double above_m = device.m.y() - skin.highest({next_m}, kNear_m);
  const double behind_m = across_m(next_m - device.m);
  const double clear = share(above_m, kLeast_m, kFull_m) * share(-behind_m, -kLeash_m, -kLoose_m);
  m_per_s_ = Vector3d(clear * m_per_s_.x(), m_per_s_.y(), clear * m_per_s_.z());
  at_.m += m_per_s_ * dt_s;
}

/// Changes the speed without a step, to one that arrives gradually: the skin under a resting pointer is noisy. The hand
/// goes down by at most `down_m_per_s`.
void GuidedHand::accelerate(const Vector3d& way_m, double down_m_per_s, double dt_s) noexcept {
  Vector3d wanted_m_per_s = at_most(way_m / kSlows_s, kFastest_m_per_s);
  wanted_m_per_s.y() = std::max(wanted_m_per_s.y(), -down_m_per_s);
  m_per_s_ += at_most(wanted_m_per_s - m_per_s_, kFastest_m_per_s2 * dt_s);
}

}  // namespace telepalp::tracking
