#include "haptic_station/surface/touch/touch.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kSteepEnough = 0.2;   // |gradient| below which f says nothing about direction (1 on a clean surface)
constexpr double kSharpCosine = 0.94;  // planes turned by more than 20 degrees in one slide make a crease
constexpr int kMostHops = 32;

double smooth_step(double t) noexcept {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

Vector3d tangential(const Vector3d& v, const Vector3d& normal) noexcept { return v - normal.dot(v) * normal; }

Vector3d shortened(const Vector3d& v, double most) noexcept {
  const double length = v.norm();
  return length > most ? Vector3d(v * (most / length)) : v;
}

/// The sliding share that would have ended at the goal, from what was left before and after (a secant in curvature): 1
/// on a plane, more on a dome, less in a bowl, where the full step overshoots by device depth over radius.
double better_slide(double slide, const Vector3d& before, const Vector3d& after) noexcept {
  const double length2 = before.squaredNorm();
  if (length2 < 1e-12) return slide;
  const double gained = 1.0 - before.dot(after) / length2;
  return gained <= 0.05 ? slide : std::clamp(slide / gained, 0.1, 2.0);
}

}  // namespace

FieldSample Touch::field(const Vector3d& at) const noexcept {
  return slew_.shown(snapshot_->evaluate(at, normal_, basis_), at);
}

void Touch::adopt(const SurfaceSnapshot& snapshot, SessionTime now) noexcept {
  if (snapshot_ != nullptr && snapshot.captured <= snapshot_captured_) ++out_of_order_;
  snapshot_ = &snapshot;
  snapshot_captured_ = snapshot.captured;
  now_ = std::max(now_, now);
  adopted_ = now_;
  if (!has_foot_) return;
  swapped_ = true;
  snapshot.prefetch(foot_);
}

/// The displayed surface at the foot. The first look at a new snapshot is also where it begins to be slewed in: a tick
/// with a swap evaluates no more often than one without.
FieldSample Touch::field_at_foot() noexcept {
  const FieldSample raw = snapshot_->evaluate(foot_, normal_, basis_);
  if (swapped_ && at_foot_.valid && raw.valid) slew_.begin(at_foot_, raw, foot_, settings_.slew);
  swapped_ = false;
  return slew_.shown(raw, foot_);
}

void Touch::release() noexcept {
  const TouchSettings settings = settings_;
  const std::uint64_t counted = out_of_order_;
  *this = Touch(settings);
  out_of_order_ = counted;
}

TouchSample Touch::step(const Point<DepthCamera>& device, SessionTime now, double dt_s) noexcept {
  now_ = std::max(now_, now);
  if (snapshot_ == nullptr || !device.m.allFinite()) return {};
  const double dt = dt_s > 0.0 ? std::min(dt_s, 0.1) : 0.0;
  slew_.advance(dt);
  basis_ = motion_basis(snapshot_->motion, age_s());
  const Vector3d from = has_device_ ? device_ : device.m;
  const double hops = std::ceil((device.m - from).norm() / settings_.longest_hop_m);
  const int parts = static_cast<int>(std::clamp(hops, 1.0, static_cast<double>(kMostHops)));
  for (int part = 1; part <= parts; ++part) look(from + (device.m - from) * (static_cast<double>(part) / parts));
  device_ = device.m;
  has_device_ = true;
  hold(dt, device.m);
  return answer(device.m);
}

/// One look at the surface from one device position: the foot follows, and the side may change.
void Touch::look(const Vector3d& device) noexcept {
  if (side_ != Side::Inside) reseed(device);
  if (!has_foot_) return;
  if (side_ == Side::Inside && !at_foot_.valid) meet_again();
  follow(device);
  if (at_foot_.valid) decide(device);
}

/// A surface that comes back under a held contact is slewed in from the plane that was held for it.
void Touch::meet_again() noexcept {
  const FieldSample fresh = snapshot_->evaluate(foot_, normal_, basis_);
  if (!fresh.valid) return;
  FieldSample held;
  held.gradient = normal_;
  slew_.begin(held, fresh, foot_, settings_.slew);
}

/// In free space the foot may be on another part of the surface: an arm held over the bed, the other side of a ridge.
/// Only a part that the device is in front of: passing behind a silhouette is not going through it.
void Touch::reseed(const Vector3d& device) noexcept {
  const std::optional<Seed> seed = snapshot_->seed(device);
  if (!seed) return;
  if (side_ == Side::Outside && !seed->query_in_front) return;
  constexpr double kClearlyNearer_m = 0.001;
  if (has_foot_ && at_foot_.valid && (device - seed->at).norm() + kClearlyNearer_m > (device - foot_).norm()) return;
  foot_ = seed->at;
  normal_ = Vector3d::Zero();
  has_foot_ = true;
  swapped_ = false;
  slew_.stop();
}

/// The surface at `goal`, which is drawn back towards the foot where it lies beyond what is known.
FieldSample Touch::farthest_known(Vector3d& goal) const noexcept {
  FieldSample there = field(goal);
  for (int halving = 0; halving < 2 && !there.valid; ++halving) {
    goal = 0.5 * (goal + foot_);
    there = field(goal);
  }
  return there;
}

/// Moves the foot to the surface point nearest to the device: Salisbury and Tarr's constraint plane, iterated, each
/// time with the tangential step that the curvature allows and a Newton step onto f = 0. Ends after one look when both
/// steps are so short that their error, their square over the support, is nothing.
void Touch::follow(const Vector3d& device) noexcept {
  FieldSample here = field_at_foot();
  ConstraintPlane last;
  for (int iteration = 0; here.valid; ++iteration) {
    const double steepness = here.gradient.norm();
    const bool steep = steepness > kSteepEnough;
    if (steep) normal_ = here.gradient / steepness;  // else the last valid plane holds: row "gradient vanishes"
    if (normal_.isZero()) normal_ = here.normal;
    const Vector3d onto = -here.f_m / std::max(steepness, kSteepEnough) * normal_;
    const Vector3d wanted = tangential(device - foot_, normal_);
    const ConstraintPlane plane{foot_ + onto, normal_};
    Vector3d slide = slide_ * wanted;
    if (!last.normal.isZero() && last.normal.dot(normal_) < kSharpCosine)
      slide = tangential(goal_in_crease(device, last, plane) - foot_, normal_);
    slide = shortened(slide, snapshot_->stride_m(foot_));
    const bool settled = std::abs(here.f_m) < settings_.settle_m && slide.norm() < settings_.settle_m;
    if (settled || iteration == settings_.most_iterations) {
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

/// Which side the device is on, once its foot is known. Below the plane but far to its side is beyond the surface's
/// rim.
void Touch::decide(const Vector3d& device) noexcept {
  const double height = height_of(device);
  if (height >= 0.0) {
    side_ = Side::Outside;
  } else if (side_ == Side::Outside) {
    if (sideways_of(device) < settings_.off_foot_m) side_ = Side::Inside;
  } else if (side_ == Side::Unknown && -height <= settings_.deepest_start_m &&
             sideways_of(device) < settings_.off_foot_m) {
    side_ = Side::Inside;
    if (settings_.slewed_start) sink_in_slowly(device);
  }
}

/// The displayed surface begins at the device and rises to where it belongs: no force out of nothing.
void Touch::sink_in_slowly(const Vector3d& device) noexcept {
  slew_.begin(-height_of(device), Vector3d::Zero(), foot_, settings_.slew);
  follow(device);
}

/// What is shown of the contact follows the support at a bounded rate, and without a surface the last plane is held
/// while it lets go.
void Touch::hold(double dt_s, const Vector3d& device) noexcept {
  double target = 0.0;
  if (has_foot_ && at_foot_.valid) {
    const double beyond = (sideways_of(device) - settings_.off_foot_m) / (2.0 * settings_.off_foot_m);
    target = at_foot_.support * freshness() * (1.0 - smooth_step(beyond));
  }
  const double most = dt_s / settings_.let_go_over_s;
  held_ = side_ == Side::Inside ? std::clamp(target, held_ - most, held_ + most) : target;
  if (side_ == Side::Inside && has_foot_ && !at_foot_.valid) foot_ += tangential(device - foot_, normal_);
  if (held_ > 0.0 || target > 0.0) return;
  if (!at_foot_.valid || side_ == Side::Inside) {
    has_foot_ = false;
    if (side_ == Side::Inside) side_ = Side::Outside;
  }
}

double Touch::height_of(const Vector3d& device) const noexcept { return normal_.dot(device - foot_); }

double Touch::sideways_of(const Vector3d& device) const noexcept { return tangential(device - foot_, normal_).norm(); }

/// A capture from the future, by a server whose clock is wrong, ages from its adoption on: it must not stay young until
/// that future has come.
double Touch::age_s() const noexcept {
  return snapshot_->motion.ages ? to_seconds(now_ - std::min(snapshot_->captured, adopted_)) : 0.0;
}

double Touch::freshness() const noexcept {
  return 1.0 - smooth_step((age_s() - settings_.stale_after_s) / settings_.let_go_over_s);
}

Displaced Touch::displaced() const noexcept {
  if (snapshot_ == nullptr || !has_foot_) return {};
  const FieldSample captured = snapshot_->evaluate(foot_, normal_, MotionBasis{});
  const FieldSample now = snapshot_->evaluate(foot_, normal_, basis_);
  if (!captured.valid || !now.valid) return {};
  return {.carried_m = captured.f_m - now.f_m, .slewed_m = now.f_m - slew_.shown(now, foot_).f_m};
}

TouchSample Touch::answer(const Vector3d& device) const noexcept {
  TouchSample out;
  out.age_s = age_s();
  out.proxy.m = device;
  out.foot.m = device;
  out.valid = has_foot_ && held_ > 0.0;
  if (!out.valid) return out;
  out.in_body = side_ == Side::Inside;
  out.foot.m = foot_;
  out.normal = normal_;
  out.distance_m = std::copysign((device - foot_).norm(), height_of(device));
  out.surface_velocity_m_per_s = at_foot_.velocity_m_per_s;
  out.uncertainty_m = std::hypot(at_foot_.deviation_m, snapshot_->motion.spread_m_per_s * out.age_s);
  out.support = held_;
  if (out.in_body) out.proxy.m = device + held_ * (foot_ - device);
  return out;
}

}  // namespace telepalp::surface
