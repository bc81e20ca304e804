#include "haptic_station/surface/touch/touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proto/words/smooth_step.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kSteepEnough = 0.2;  // |gradient| below which f says nothing about direction (1 on a clean surface)
constexpr double kSteepestCarried = 0.5;  // cosine of the steepest skin, 60 degrees, that moves along the depth axis
constexpr double kSharpCosine = 0.94;     // planes turned by more than 20 degrees in one slide make a crease
constexpr int kMostHops = 32;
constexpr double kLongestHop_m = 0.004;  // a longer move of the device is searched in parts, to miss no surface
constexpr int kMostIterations = 4;       // of one search for the foot; each evaluates the surface at least once
constexpr double kSettle_m = 2e-5;  // a shorter step of the foot ends the search: the error left is of second order
constexpr double kOtherSurface_m = 0.045;  // a surface that jumps farther than this during a contact is another surface
constexpr double kOffFoot_m = 0.004;       // a device tangentially farther than this from its foot is beyond the rim
constexpr double kFootPerDevice = 3.0;     // largest ratio of the foot's movement to the device's, as on a dome
constexpr double kFoot_m_per_s = 0.10;     // largest speed of the foot under a device at rest
constexpr double kHeldPlane_m_per_s = 0.1;  // largest speed at which the foot slides on a held plane
constexpr double kLeastShown = 0.05;        // least displayed share at which a contact begins
constexpr double kFreeDepth_m = 0.03;       // to this depth of a device without force, the skin rises faster
constexpr double kLongestTick_s = 0.01;     // longest tick over which the controller computes a speed
constexpr double kAnchorLook_s = 0.0039;    // time between evaluations at the anchor; just under eight ticks

Vector3d tangential(const Vector3d& v, const Vector3d& normal) noexcept { return v - normal.dot(v) * normal; }

Vector3d shortened(const Vector3d& v, double most) noexcept {
  const double length = v.norm();
  return length > most ? Vector3d(v * (most / length)) : v;
}

/// True if the camera sees a surface on the ray through `device`, at most `deepest_m` from it.
bool is_seen_near(const SurfaceSnapshot& snapshot, const Vector3d& device, double deepest_m) noexcept {
  const std::optional<Seed> seed = snapshot.seed(device);
  return seed && (seed->at - device).norm() <= deepest_m;
}

/// The share of the tangential step that would have reached the goal, from the distance left before and after the step
/// (a secant method): 1 on a plane, more on a dome, less in a bowl. In a bowl the full step overshoots by the ratio of
/// the device's depth to the radius.
double better_slide(double slide, const Vector3d& before, const Vector3d& after) noexcept {
  const double length2 = before.squaredNorm();
  if (length2 < 1e-12) return slide;
  const double gained = 1.0 - before.dot(after) / length2;
  return gained <= 0.05 ? slide : std::clamp(slide / gained, 0.1, 2.0);
}

/// The direction in which skin with this normal is taken to move. A depth image does not show motion within the
/// surface. Breath, a cough and a patient who sits up move the body towards the camera; if the anchor on a flank moved
/// along the normal, it would leave its place on the skin sideways. On steeper skin the depth axis hardly meets the
/// surface.
Vector3d carried_along(const Vector3d& normal) noexcept {
  const Vector3d to_camera = -Vector3d::UnitZ();
  return normal.dot(to_camera) >= kSteepestCarried ? to_camera : normal;
}

/// The limits along a line that meets the skin's normal at this cosine. The line's motion is longer than the skin's
/// along its normal, so without this a step of the force on a flank would be larger.
FollowLimits on_slope(FollowLimits limits, double cosine) noexcept {
  const double share = std::clamp(cosine, kSteepestCarried, 1.0);
  limits.speed_m_per_s *= share;
  limits.acceleration_m_per_s2 *= share;
  return limits;
}

}  // namespace

FieldSample Touch::field(const Vector3d& at) const noexcept {
  return follower_.shown(snapshot_->evaluate(follower_.on_newest(at), normal_, basis_));
}

void Touch::adopt(const SurfaceSnapshot& snapshot, SessionTime now) noexcept {
  if (snapshot_ != nullptr && snapshot.captured <= snapshot_captured_) ++out_of_order_;
  snapshot_ = &snapshot;
  snapshot_captured_ = snapshot.captured;
  now_ = std::max(now_, now);
  adopted_ = now_;
  if (!has_foot_) return;
  swapped_ = true;
  snapshot.prefetch(follower_.on_newest(foot_));
}

/// The displayed surface at the foot. A newer snapshot takes over at the displayed position. A tick with a swap
/// therefore evaluates the surface as often as one without, unless the surface has jumped.
FieldSample Touch::field_at_foot() noexcept {
  const bool met_anew = !fresh_foot_ && (swapped_ || !at_foot_.valid);
  const Vector3d there = follower_.on_newest(foot_);
  const FieldSample newest = met_anew ? meet(there) : snapshot_->evaluate(there, normal_, basis_);
  if (newest.valid) newest_velocity_ = newest.velocity_m_per_s;
  if (newest.valid && fresh_foot_) follower_.follow_at_once(newest.normal, newest.velocity_m_per_s);
  swapped_ = fresh_foot_ = false;
  return follower_.shown(newest);
}

/// The newest surface near `expected`, the point that corresponds to the displayed foot. If it is not within the gate,
/// it is searched along the camera's ray. During a contact, a surface that has jumped too far counts as another
/// surface.
FieldSample Touch::meet(const Vector3d& expected) noexcept {
  Vector3d there = expected;
  FieldSample newest = snapshot_->evaluate(there, normal_, basis_);
  if (!newest.valid) {
    const std::optional<Seed> seed = snapshot_->seed(expected);
    if (!seed) return {};
    there = expected + normal_.dot(seed->at - expected) * normal_;
    newest = snapshot_->evaluate(there, normal_, basis_);
    if (!newest.valid) newest = snapshot_->evaluate(there = seed->at, normal_, basis_);
  }
  const double steepness = newest.gradient.norm();
  if (!newest.valid || steepness < kSteepEnough || normal_.isZero()) return newest;
  there -= newest.f_m / (steepness * steepness) * newest.gradient;
  const double farthest_m = side_ == Side::Inside ? kOtherSurface_m : kDeepestStart_m;
  if (std::min((there - expected).norm(), (there - foot_).norm()) > farthest_m) return {};
  follower_.take_over(foot_, normal_, there, newest.gradient / steepness);
  newest.f_m = 0.0;
  return newest;
}

void Touch::release() noexcept {
  const std::uint64_t counted = out_of_order_;
  *this = Touch(TouchSettings(settings_), FollowLimits(follow_));
  out_of_order_ = counted;
}

TouchSample Touch::step(const Point<DepthCamera>& device, SessionTime now, double dt_s, bool felt) noexcept {
  now_ = std::max(now_, now);
  if (snapshot_ == nullptr || !device.m.allFinite()) return {};
  const double dt = dt_s > 0.0 ? std::min(dt_s, 0.1) : 0.0;
  const FollowLimits limits = slowed_by_age(follow_, age_s());
  follower_.set_limits(limits);
  anchor_.set_limits(anchored_ ? on_slope(limits, normal_.dot(anchor_.along())) : limits);
  carry_on(dt, felt);
  basis_ = motion_basis(snapshot_->motion, age_s());
  const Vector3d from = has_device_ ? device_ : device.m;
  const double hops = std::ceil((device.m - from).norm() / kLongestHop_m);
  const int parts = static_cast<int>(std::clamp(hops, 1.0, static_cast<double>(kMostHops)));
  if (!felt) end_too_deep(device.m);
  const bool was_inside = side_ == Side::Inside && at_foot_.valid;
  const Vector3d foot_before = foot_;
  const double depth_before_m = normal_.dot(foot_ - device.m);
  for (int part = 1; part <= parts; ++part) look(from + (device.m - from) * (static_cast<double>(part) / parts));
  const double foot_most_m = kFootPerDevice * (device.m - from).norm() + kFoot_m_per_s * dt;
  if (was_inside && side_ == Side::Inside)  // under a deep device the nearest skin point can jump far to the side
    foot_ = foot_before + shortened(foot_ - foot_before, foot_most_m);
  else if (was_inside &&
           (glides_ || depth_before_m > foot_most_m))  // if less deep, the skin fell or the device came out
    leave(device.m, foot_before, foot_most_m, dt);
  device_ = device.m;
  has_device_ = true;
  if (felt)
    follow_anchor(dt);
  else
    anchored_ = false;  // a contact that is not felt has no anchor: the hand slides
  hold(dt, device.m, felt);
  return answer(device.m);
}

/// Handles a device that is no longer inside the body. `foot_before`: the foot of the tick before. A device that came
/// out through the skin is within `near_m` of this foot. A device that is farther away fell into a fold, or passed into
/// another wall. The displayed skin then glides to the device, and the next contact may begin when it is there.
void Touch::leave(const Vector3d& device, const Vector3d& foot_before, double near_m, double dt_s) noexcept {
  const Vector3d pulled = foot_before - device;
  if (pulled.norm() > near_m) {
    side_ = Side::Inside;
    glides_ = true;
    foot_ = foot_before - shortened(pulled, kFoot_m_per_s * dt_s);
    normal_ = pulled.normalized();
    return;
  }
  if (!std::exchange(glides_, false)) return;
  side_ = Side::Unknown;
  was_in_front_ = false;
}

/// Ends a contact that gives no force, as after a release, when the device is deeper than any contact may begin
/// (kDeepestStart_m). The device must then be lifted before the next contact.
void Touch::end_too_deep(const Vector3d& device) noexcept {
  if (side_ != Side::Inside || -height_of(device) <= kDeepestStart_m) return;
  side_ = Side::Unknown;
  held_ = 0.0;
}

/// Moves the displayed surface and the foot with it by one tick. The skin may rise faster where it gives no force:
/// below a device that is outside, and over the first kFreeDepth_m of a contact that is not felt. When the force
/// begins, the station lowers the body to the device.
void Touch::carry_on(double dt_s, bool felt) noexcept {
  if (!has_foot_ || !at_foot_.valid) return;
  const double above_m = height_of(device_);
  const double gap_m = side_ != Side::Inside ? above_m : felt ? 0.0 : above_m + kFreeDepth_m;
  follower_.advance(foot_, normal_, newest_velocity_, gap_m, dt_s);
  foot_ += dt_s * follower_.velocity_m_per_s();
}

/// Evaluates the surface for one device position: moves the foot and decides on the side.
void Touch::look(const Vector3d& device) noexcept {
  if (side_ != Side::Inside) reseed(device);
  if (!has_foot_) return;
  follow(device);
  if (at_foot_.valid) decide(device);
}

/// Searches the foot anew while the device is in free space. Another part of the surface may be nearer, such as an arm
/// over the bed or the other side of a ridge. Only a part that has the device on its outer side is accepted, because a
/// device behind a silhouette has not gone through the skin.
void Touch::reseed(const Vector3d& device) noexcept {
  const std::optional<Seed> seed = snapshot_->seed(device);
  if (!seed) return;
  if (side_ == Side::Outside && !seed->query_in_front) return;
  constexpr double kClearlyNearer_m = 0.001;
  if (has_foot_ && at_foot_.valid && (device - seed->at).norm() + kClearlyNearer_m > (device - foot_).norm()) return;
  foot_ = seed->at;
  normal_ = Vector3d::Zero();
  has_foot_ = fresh_foot_ = true;
  was_in_front_ = seed->query_in_front;
  follower_.follow_at_once(normal_, 0.0);
}

/// The surface at `goal`. If the surface is unknown there, `goal` is moved back towards the foot.
FieldSample Touch::farthest_known(Vector3d& goal) const noexcept {
  FieldSample there = field(goal);
  for (int halving = 0; halving < 2 && !there.valid; ++halving) {
    goal = 0.5 * (goal + foot_);
    there = field(goal);
  }
  return there;
}

/// Moves the foot to the surface point nearest to the device. Iterates Salisbury and Tarr's constraint plane: each
/// iteration makes the tangential step that the curvature allows and a Newton step onto f = 0. It ends after one
/// evaluation if both steps are so short that their error, step² / support, is negligible.
void Touch::follow(const Vector3d& device) noexcept {
  FieldSample here = field_at_foot();
  ConstraintPlane last;
  for (int iteration = 0; here.valid; ++iteration) {
    const double steepness = here.gradient.norm();
    const bool steep = steepness > kSteepEnough;
    if (steep) normal_ = here.gradient / steepness;  // else the last valid normal is kept
    if (normal_.isZero()) normal_ = here.normal;
    const Vector3d onto = -here.f_m / std::max(steepness, kSteepEnough) * normal_;
    const Vector3d wanted = tangential(device - foot_, normal_);
    const ConstraintPlane plane{foot_ + onto, normal_};
    Vector3d slide = slide_ * wanted;
    if (!last.normal.isZero() && last.normal.dot(normal_) < kSharpCosine)
      slide = tangential(goal_in_crease(device, last, plane) - foot_, normal_);
    slide = shortened(slide, snapshot_->stride_m(foot_));
    const bool settled = std::abs(here.f_m) < kSettle_m && slide.norm() < kSettle_m;
    if (settled || iteration == kMostIterations) {
      foot_ += onto + (settled ? slide : Vector3d::Zero());
      here.f_m = 0.0;
      break;
    }
    Vector3d goal = foot_ + onto + slide;
    const FieldSample there = farthest_known(goal);
    if (!there.valid) break;
    if (there.gradient.norm() > kSteepEnough)
      slide_ = better_slide(slide_, slide.norm() > 0.0 ? wanted : Vector3d::Zero(),
                            tangential(device - goal, there.gradient.normalized()));
    last = plane;
    foot_ = goal;
    here = there;
  }
  at_foot_ = here;
}

/// Decides on which side the device is, once its foot is known. A device below the plane but far to the side of its
/// foot is beyond the rim of the surface. For a device that is in the body without having passed the displayed skin,
/// the contact begins gradually. It waits until the camera sees skin near the device: while another hand covers that
/// skin, the nearest skin in sight lies to the side, and its force would push the device out from under the finger.
void Touch::decide(const Vector3d& device) noexcept {
  const double height = height_of(device);
  const bool was_in_front = std::exchange(was_in_front_, height >= 0.0);
  if (height >= 0.0) {
    side_ = Side::Outside;
    return;
  }
  if (side_ == Side::Inside || sideways_of(device) >= kOffFoot_m) return;
  if (side_ == Side::Unknown && !is_seen_near(*snapshot_, device, kDeepestStart_m)) return;
  if (at_foot_.coverage * freshness() < kLeastShown) return;
  side_ = Side::Inside;
  if (!was_in_front && settings_.gentle_start) show_at(device);
}

/// Displays the surface at the device, from where it rises to its true place, so that the force starts at zero. The
/// displayed share has its full value from the beginning. At zero depth it changes no force; if it grew later, over a
/// deep device, it would compress the skin's spring without work of the hand.
void Touch::show_at(const Vector3d& device) noexcept {
  const Vector3d there = follower_.on_newest(foot_);
  follower_.take_over(device, normal_, there, normal_);
  foot_ = device;
  held_ = at_foot_.coverage * freshness();
}

/// Evaluates the newest surface at the anchor, so that no error accumulates.
void Touch::look_at_anchor() noexcept {
  const Vector3d& along = anchor_.along();
  Vector3d there = anchor_.at() + anchor_lag_m_ * along;
  FieldSample newest = snapshot_->evaluate(there, along, basis_);
  if (!newest.valid) {
    if (const std::optional<Seed> seed = snapshot_->seed(there)) {
      there = anchor_.at() + along.dot(seed->at - anchor_.at()) * along;
      newest = snapshot_->evaluate(there, along, basis_);
    }
  }
  const double slope = newest.gradient.dot(along);
  const double lag_m = along.dot(there - anchor_.at()) - newest.f_m / std::max(slope, kSteepEnough);
  anchor_seen_ = newest.valid && slope > kSteepEnough && std::abs(lag_m) < kDeepestStart_m;
  if (!anchor_seen_) return;
  anchor_lag_m_ = lag_m;
  anchor_target_m_per_s_ = newest.velocity_m_per_s / slope;
}

/// Follows the skin at the point where the contact began, on a line [carried_along()]. The displayed anchor follows
/// the newest surface there like the skin under the device. Every 4 ms the surface is evaluated; meanwhile it moves on
/// at its speed there. If the surface is not known there, the anchor moves with the foot.
void Touch::follow_anchor(double dt_s) noexcept {
  anchor_speed_ = 0.0;
  const bool begins = side_ == Side::Inside && !anchored_;
  anchored_ = side_ == Side::Inside;
  if (!anchored_) return;
  if (begins) {
    const Vector3d along = carried_along(normal_);
    const double slope = normal_.dot(along);
    anchor_.begin(foot_, along, follower_.velocity_m_per_s().dot(normal_) / slope);
    anchor_lag_m_ = follower_.lag_m().dot(normal_) / slope;
    anchor_looked_s_ = kAnchorLook_s;
  }
  const double part_s = std::min(dt_s, kLongestTick_s);
  anchor_looked_s_ += part_s;
  if (anchor_looked_s_ >= kAnchorLook_s) {
    look_at_anchor();
    anchor_looked_s_ = 0.0;
  }
  const Vector3d& along = anchor_.along();
  const double slope = std::max(normal_.dot(along), kSteepestCarried);
  const double target_m_per_s = anchor_seen_ ? anchor_target_m_per_s_ : newest_velocity_ / slope;
  const double before_m = anchor_.risen_m();
  anchor_.advance(anchor_seen_ ? anchor_lag_m_ : 0.0, target_m_per_s, part_s);
  const double rose_m = anchor_.risen_m() - before_m;
  anchor_lag_m_ += (anchor_seen_ ? target_m_per_s * part_s : 0.0) - rose_m;
  anchor_speed_ = part_s > 0.0 ? rose_m / part_s : anchor_.rate_m_per_s();
}

/// The displayed share of the contact follows the coverage at a bounded rate. Without a surface, the last plane is held
/// while the contact fades. While the contact gives no force, its share rises to a greater coverage at once: a share
/// that grew after the force has begun would stiffen the skin under the hand, and give energy to the hand.
void Touch::hold(double dt_s, const Vector3d& device, bool felt) noexcept {
  double target = 0.0;
  if (has_foot_ && at_foot_.valid) {
    const double beyond = (sideways_of(device) - kOffFoot_m) / (2.0 * kOffFoot_m);
    target = at_foot_.coverage * freshness() * (1.0 - smooth_step(beyond));
  }
  const double most = dt_s / kLetGoOver_s;
  held_ = side_ == Side::Inside ? std::clamp(target, held_ - most, felt ? held_ + most : 1.0) : target;
  if (side_ == Side::Inside && has_foot_ && !at_foot_.valid)
    foot_ += shortened(tangential(device - foot_, normal_), kHeldPlane_m_per_s * dt_s);
  if (held_ > 0.0 || target > 0.0) return;
  if (at_foot_.valid && side_ != Side::Inside) return;
  has_foot_ = false;
  side_ = Side::Unknown;
  anchored_ = false;  // the next contact may begin in the next tick, elsewhere
}

double Touch::height_of(const Vector3d& device) const noexcept { return normal_.dot(device - foot_); }

double Touch::sideways_of(const Vector3d& device) const noexcept { return tangential(device - foot_, normal_).norm(); }

/// A capture time in the future comes from a server whose clock is wrong. Such a snapshot ages from its adoption,
/// because otherwise it would not become stale for long.
double Touch::age_s() const noexcept {
  return snapshot_->motion.ages ? to_seconds(now_ - std::min(snapshot_->captured, adopted_)) : 0.0;
}

double Touch::freshness() const noexcept {
  return 1.0 - smooth_step((age_s() - settings_.stale_after_s) / kLetGoOver_s);
}

Displaced Touch::displaced() const noexcept {
  if (snapshot_ == nullptr || !has_foot_) return {};
  const Vector3d there = follower_.on_newest(foot_);
  const FieldSample captured = snapshot_->evaluate(there, normal_, MotionBasis{});
  const FieldSample now = snapshot_->evaluate(there, normal_, basis_);
  if (!captured.valid || !now.valid) return {};
  return {.carried_m = captured.f_m - now.f_m, .slewed_m = -follower_.lag_m().dot(normal_)};
}

TouchSample Touch::answer(const Vector3d& device) const noexcept {
  TouchSample out;
  out.age_s = age_s();
  out.unmodelled = snapshot_->motion.unmodelled;
  out.proxy.m = device;
  out.foot.m = device;
  out.valid = has_foot_ && held_ > 0.0;
  if (!out.valid) return out;
  out.in_body = side_ == Side::Inside;
  out.foot.m = foot_;
  out.normal = normal_;
  out.distance_m = std::copysign((device - foot_).norm(), height_of(device));
  out.surface_velocity_m_per_s = follower_.velocity_m_per_s().dot(normal_);
  out.newest_above_m = follower_.lag_m().dot(normal_);
  out.newest_velocity_m_per_s = newest_velocity_;
  if (anchored_) out.anchor_velocity_m_per_s = anchor_speed_ * anchor_.along();
  out.uncertainty_m = std::hypot(at_foot_.deviation_m, snapshot_->motion.spread_m_per_s * out.age_s);
  out.coverage = held_;
  if (out.in_body) out.proxy.m = device + held_ * (foot_ - device);
  return out;
}

}  // namespace telepalp::surface
