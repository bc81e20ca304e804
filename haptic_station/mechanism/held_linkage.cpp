#include "haptic_station/mechanism/held_linkage.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/mechanism/crank_range.h"

namespace telepalp::mechanism {
namespace {

constexpr double kOnPivot_m = 1e-6;     // nearer to O, the angle GOT is undefined
constexpr double kNearOneLine = 0.1;    // below this sine of links 1 and 2, choose_side() compares branches
constexpr double kNearTogether = 0.05;  // the same, for |AB| as a share of l1 + l2

double length(const InPlane<double>& a) noexcept { return std::hypot(a.x, a.y); }
double cross(const InPlane<double>& a, const InPlane<double>& b) noexcept { return a.x * b.y - a.y * b.x; }

}  // namespace

/// Motions of the held point G' and of the tip in the same turn of link 3 [m/rad]. Both are multiplied by the sine of
/// links 1 and 2, so that they are finite at a dead point. G' moves by `along_hand` along the unit vector `hand`.
struct HeldLinkage::Motion {
  InPlane<double> hand;
  double along_hand = 0.0;
  InPlane<double> tip;
};

HeldLinkage::HeldLinkage(const FourBar& bar, const LinkagePlane& plane, double link3_rad, Branch branch,
                         const HoldSettings& settings) noexcept
    : bar_(bar),
      wanted_(bar),
      plane_(plane),
      settings_(settings),
      link3_rad_(link3_rad),
      side_(branch == Branch::Open ? 1.0 : -1.0) {
  close_loop();
  remember_turning(pose_);
  hand_m_ = grasp().m;
}

void HeldLinkage::step(const Point<HapticBase>& hand, double dt_s) noexcept {
  const Eigen::Vector3d tip_before = tip().m;
  approach(bar_, wanted_, settings_.slew, dt_s);
  const bool seen = hand.m.allFinite();
  const Eigen::Vector3d from_a = hand.m - plane_.pivot_a.m;
  if (seen) turn_to({plane_.x.v.dot(from_a), plane_.y.v.dot(from_a)}, dt_s);
  link3_rad_ = crank_range(bar_, link3_rad_).nearest(link3_rad_);
  choose_side();
  close_loop();
  hand_m_ = seen ? hand.m : grasp().m;
  tip_velocity_ = dt_s > 0.0 ? Eigen::Vector3d((tip().m - tip_before) / dt_s) : Eigen::Vector3d::Zero();
}

/// Turns link 3 by the angle GOT, at most as fast as the settings say.
void HeldLinkage::turn_to(const InPlane<double>& hand, double dt_s) noexcept {
  const InPlane<double> from_o{hand.x - bar_.l4_m, hand.y};
  if (length(from_o) < kOnPivot_m) return;
  const double held_rad = link3_rad_ + lever_of(bar_, settings_.held_share).from_link3_rad;
  const double got_rad = std::remainder(std::atan2(from_o.y, from_o.x) - held_rad, kTurn_rad);
  const double most_rad = settings_.fastest_rad_per_s * dt_s;
  link3_rad_ += std::clamp(got_rad, -most_rad, most_rad);
}

/// Only a change-point linkage can go on through a pose in which links 1 and 2 lie on one line. Of its two branches, it
/// takes the one on which link 1 continues its turn.
void HeldLinkage::choose_side() noexcept {
  if (grashof_class(bar_) != GrashofClass::ChangePoint) return;
  const FourBarPose<double> same = four_bar_pose(bar_, link3_rad_, side_);
  const double sine = std::abs(cross(same.b, same.p)) / (bar_.l1_m * bar_.l2_m);
  if (sine > kNearOneLine && length(same.b) > kNearTogether * (bar_.l1_m + bar_.l2_m)) {
    remember_turning(same);
    return;
  }
  const double expected_rad = link1_rad_ + link1_per_link3_ * (link3_rad_ - left_at_rad_);
  const FourBarPose<double> other = four_bar_pose(bar_, link3_rad_, -side_);
  const auto miss_rad = [&](const FourBarPose<double>& pose) {
    return std::abs(std::remainder(std::atan2(pose.p.y, pose.p.x) - expected_rad, kTurn_rad));
  };
  if (miss_rad(other) < miss_rad(same)) side_ = -side_;
}

/// Stores the angle of link 1 in `pose`, and how far link 1 turns for each radian of link 3. The latter follows because
/// P turns about A and keeps its distance from B.
void HeldLinkage::remember_turning(const FourBarPose<double>& pose) noexcept {
  const double turned = cross(pose.b, pose.p);
  if (turned == 0.0) return;
  const InPlane<double> of_b = left_of(pose.b - InPlane<double>{bar_.l4_m, 0.0});
  link1_per_link3_ = dot(of_b, pose.p - pose.b) / turned;
  link1_rad_ = std::atan2(pose.p.y, pose.p.x);
  left_at_rad_ = link3_rad_;
}

void HeldLinkage::close_loop() noexcept {
  const FourBarPose<double> next = four_bar_pose(bar_, link3_rad_, side_);
  if (std::isfinite(next.p.x) && std::isfinite(next.p.y)) pose_ = next;
  const Lever lever = lever_of(bar_, settings_.held_share);
  const double angle_rad = link3_rad_ + lever.from_link3_rad;
  held_ = {bar_.l4_m + lever.length_m * std::cos(angle_rad), lever.length_m * std::sin(angle_rad)};
}

double HeldLinkage::sine_of_links() const noexcept {
  return cross(pose_.b - pose_.p, pose_.p) / (bar_.l1_m * bar_.l2_m);
}

HeldLinkage::Motion HeldLinkage::motion() const noexcept {
  const InPlane<double> from_o = held_ - InPlane<double>{bar_.l4_m, 0.0};
  const double lever_m = length(from_o);
  const InPlane<double> of_b = left_of(pose_.b - InPlane<double>{bar_.l4_m, 0.0});  // for each radian of link 3
  const double sine = sine_of_links();
  // P turns about A and, with link 2, about B: v_B + w2 left(BP) is at a right angle to AP.
  const double link2_turn = dot(of_b, pose_.p) / (bar_.l1_m * bar_.l2_m);
  const InPlane<double> tip = sine * of_b + link2_turn * left_of(pose_.tip - pose_.b);
  return {(1.0 / lever_m) * left_of(from_o), sine * lever_m, tip};
}

Force<HapticBase> HeldLinkage::constraint_force() const noexcept {
  return {settings_.stiffness_N_per_m * (grasp().m - hand_m_)};
}

Force<HapticBase> HeldLinkage::hand_force(const Force<HapticBase>& at_tip) const noexcept {
  if (!at_tip.N.allFinite()) return {};
  const Motion moved = motion();
  const InPlane<double> force{plane_.x.v.dot(at_tip.N), plane_.y.v.dot(at_tip.N)};
  const double least = length(moved.tip) / settings_.most_gain;
  const double along = std::copysign(std::max(std::abs(moved.along_hand), least), side_);
  if (along == 0.0) return {};
  const double N = dot(moved.tip, force) / along;
  return {N * (moved.hand.x * plane_.x.v + moved.hand.y * plane_.y.v)};
}

double HeldLinkage::tip_travel() const noexcept {
  const Motion moved = motion();
  const double tip = length(moved.tip);
  return tip / std::max({std::abs(moved.along_hand), tip / settings_.most_gain, 1e-12});
}

Vector<HapticBase> HeldLinkage::needle_axis() const noexcept {
  return {pose_.axis.x * plane_.x.v + pose_.axis.y * plane_.y.v};
}
Vector<HapticBase> HeldLinkage::tip_velocity() const noexcept { return {tip_velocity_}; }

Point<HapticBase> HeldLinkage::in_space(const InPlane<double>& at) const noexcept {
  return {plane_.pivot_a.m + at.x * plane_.x.v + at.y * plane_.y.v};
}

}  // namespace telepalp::mechanism
