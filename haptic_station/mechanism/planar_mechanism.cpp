#include "haptic_station/mechanism/planar_mechanism.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "haptic_station/mechanism/constraint_rows.h"

namespace telepalp::mechanism {
namespace {

constexpr int kMostIterations = 16;
constexpr int kMostHalvings = 8;
constexpr double kMostTurn_rad = 0.1;  // of a body in one iteration
constexpr double kMostMove_m = 0.02;   // of a body's origin in one iteration
constexpr double kClosed_m = 1e-7;     // a pose with a wider gap is not adopted
constexpr double kRounding_m = 1e-13;
constexpr double kStill = 1e-11;  // a smaller change ends the search

/// Largest share of `change` that moves no body further than the limits above.
double share_within_limits(const PlanarPose& change) noexcept {
  double share = 1.0;
  for (int i = 0; i < change.size(); ++i) {
    const double most = i % 3 == 2 ? kMostTurn_rad : kMostMove_m;
    if (std::abs(change[i]) > most / share) share = most / std::abs(change[i]);
  }
  return share;
}

}  // namespace

/// The mechanism linearised at a pose.
struct HeldMechanism::Linear {
  PlanarPose to_closed;  // change that closes the joints
  Freedoms free;
  Motion grasp_motion;
  double open_m = 0.0;
};

HeldMechanism::HeldMechanism(const PlanarMechanism& mechanism, const PlanarPose& pose, double most_gain) noexcept
    : mechanism_(mechanism), most_gain_(most_gain), pose_(pose) {
  adopt(pose_, linear_at(pose_));
}

void HeldMechanism::hold_at(const BodyPoint& point) noexcept {
  mechanism_.grasp = point;
  adopt(pose_, linear_at(pose_));
}

bool HeldMechanism::change(const PlanarMechanism& mechanism) noexcept {
  const PlanarMechanism before = mechanism_;
  mechanism_ = mechanism;
  PlanarPose next = pose_;
  Linear linear = linear_at(next);
  for (int i = 0; i < 4 && linear.open_m > kRounding_m; ++i) {
    next += linear.to_closed;
    linear = linear_at(next);
  }
  const bool closes = linear.open_m < kClosed_m && !passes_dead_point(linear);
  if (closes)
    adopt(next, linear);
  else
    mechanism_ = before;
  return closes;
}

HeldMechanism::Linear HeldMechanism::linear_at(const PlanarPose& pose) const noexcept {
  const JointEquations equations = joint_equations(mechanism_, pose);
  Solutions solutions = solutions_of(equations);
  Linear out;
  out.to_closed = solutions.one;
  out.free = solutions.free;
  out.grasp_motion = motion_of(mechanism_.grasp, pose).lazyProduct(solutions.free);
  out.open_m = equations.errors.size() > 0 ? equations.errors.cwiseAbs().maxCoeff() : 0.0;
  return out;
}

void HeldMechanism::adopt(const PlanarPose& pose, const Linear& linear) noexcept {
  pose_ = pose;
  free_ = linear.free;
  grasp_motion_ = linear.grasp_motion;
  tip_motion_ = motion_of(mechanism_.tip, pose).lazyProduct(free_);
  if (free_.cols() == 1 && grasp_motion_.norm() > 1e-12) last_way_ = grasp_motion_.col(0).normalized();
}

/// True if a dead point lies between the adopted pose and the next one. With one degree of freedom, the held point then
/// turns back. With two, the determinant of its motions changes its sign. The basis of the motions may change its sign
/// from pose to pose, too, so the product takes this sign out.
bool HeldMechanism::passes_dead_point(const Linear& next) const noexcept {
  if (next.free.cols() != free_.cols()) return true;
  if (free_.cols() == 1) {
    const double same_way = free_.col(0).dot(next.free.col(0));
    return same_way * grasp_motion_.col(0).dot(next.grasp_motion.col(0)) < 0.0;
  }
  if (free_.cols() != 2) return false;
  const Eigen::Matrix2d between = free_.transpose().lazyProduct(next.free);
  const Eigen::Matrix2d before = grasp_motion_;
  const Eigen::Matrix2d after = next.grasp_motion;
  return between.determinant() * before.determinant() * after.determinant() < 0.0;
}

void HeldMechanism::step(const Eigen::Vector2d& hand_m) noexcept {
  if (!hand_m.allFinite()) return;
  for (int i = 0; i < kMostIterations; ++i)
    if (!improve(hand_m)) return;
}

/// One Gauss-Newton step towards the hand, and steps that close the joints again. False: it found no better pose.
bool HeldMechanism::improve(const Eigen::Vector2d& hand_m) noexcept {
  const Eigen::Vector2d miss_m = hand_m - grasp_m();
  using Square = Eigen::Matrix<double, 2, 2>;
  const auto freedoms = free_.cols();
  if (freedoms < 1 || freedoms > 2) return false;
  Square normal = Square::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  normal.topLeftCorner(freedoms, freedoms) = grasp_motion_.transpose().lazyProduct(grasp_motion_);
  right.head(freedoms) = grasp_motion_.transpose().lazyProduct(miss_m);
  normal.diagonal().head(freedoms).array() += 1e-12 * free_.colwise().squaredNorm().maxCoeff();
  const Eigen::Vector2d along = normal.inverse() * right;
  PlanarPose change = free_.lazyProduct(along.head(freedoms));
  change *= share_within_limits(change);
  if (!(change.cwiseAbs().maxCoeff() > kStill)) return false;
  for (int halving = 0; halving < kMostHalvings; ++halving, change *= 0.5) {
    PlanarPose next = pose_ + change;
    Linear linear = linear_at(next);
    for (int i = 0; i < 4 && linear.open_m > kRounding_m; ++i) {
      next += linear.to_closed;
      linear = linear_at(next);
    }
    if (!(linear.open_m < kClosed_m) || passes_dead_point(linear)) continue;
    if ((hand_m - place_of(mechanism_.grasp, next)).squaredNorm() >= miss_m.squaredNorm()) continue;
    adopt(next, linear);
    return true;
  }
  return false;
}

Eigen::Vector2d HeldMechanism::grasp_m() const noexcept { return place_of(mechanism_.grasp, pose_); }
Eigen::Vector2d HeldMechanism::tip_m() const noexcept { return place_of(mechanism_.tip, pose_); }
Eigen::Vector2d HeldMechanism::where_m(const BodyPoint& point) const noexcept { return place_of(point, pose_); }
double HeldMechanism::open_m() const noexcept {
  const JointEquations equations = joint_equations(mechanism_, pose_);
  return equations.errors.size() > 0 ? equations.errors.cwiseAbs().maxCoeff() : 0.0;
}

Eigen::Vector2d HeldMechanism::hand_force_N(const Eigen::Vector2d& at_tip_N) const noexcept {
  if (!at_tip_N.allFinite() || free_.cols() < 1 || free_.cols() > 2) return Eigen::Vector2d::Zero();
  const double least = tip_motion_.norm() / most_gain_;
  if (free_.cols() == 1) {
    const Eigen::Vector2d moves = grasp_motion_.col(0);
    const double length = moves.norm();
    const Eigen::Vector2d way = length > 1e-12 ? Eigen::Vector2d(moves / length) : last_way_;
    const double divisor = std::max(length, least);
    return divisor > 0.0 ? Eigen::Vector2d(tip_motion_.col(0).dot(at_tip_N) / divisor * way)
                         : Eigen::Vector2d(Eigen::Vector2d::Zero());
  }
  const Eigen::Matrix2d moves = grasp_motion_;
  const Eigen::JacobiSVD<Eigen::Matrix2d> parts(moves, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector2d work =
      parts.matrixV().transpose() * Eigen::Vector2d(tip_motion_.transpose().lazyProduct(at_tip_N));
  Eigen::Vector2d force = Eigen::Vector2d::Zero();
  for (int i = 0; i < 2; ++i)
    if (const double divisor = std::max(parts.singularValues()[i], least); divisor > 0.0)
      force += work[i] / divisor * parts.matrixU().col(i);
  return force;
}

}  // namespace telepalp::mechanism
