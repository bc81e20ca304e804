#include "haptic_station/control/encountered_controller.h"

#include <algorithm>
#include <cmath>

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

constexpr double kHandSmoothing_rad_per_s = 25.0;  // bandwidth of the filter over the tracker's 100 Hz steps
constexpr double kPositionSlew_N_per_s = 56.0;     // 0.028 N a tick
constexpr double kSinkIn_m_per_s = 0.03;
constexpr double kSinkInEases_s = 0.05;  // and slower over the last 1.5 mm: damping must not feel it end
constexpr double kSinkInSlowest_m_per_s = 0.0003;
constexpr double kReleaseWithin_s = 0.03;  // from peak force to none

Vector3d at_most(const Vector3d& vector, double length) noexcept {
  const double norm = vector.norm();
  return norm > length ? Vector3d(vector * (length / norm)) : vector;
}

/// One step of a critically damped approach to zero of (value, rate), exact for any step length.
template <class Moving>
void approach_zero(Moving& moving, double omega_rad_per_s, double dt_s) noexcept {
  const double decay = std::exp(-omega_rad_per_s * dt_s);
  const Vector3d slope = moving.per_s + omega_rad_per_s * moving.m;
  const Vector3d value = (moving.m + slope * dt_s) * decay;
  moving.per_s = (moving.per_s - omega_rad_per_s * slope * dt_s) * decay;
  moving.m = value;
}

bool is_finite(const ControlInput& in) noexcept {
  return in.device.m.allFinite() && in.device_velocity.v.allFinite() && std::isfinite(in.device_age_s) &&
         (!in.hand_valid || (in.hand.m.allFinite() && in.hand_velocity.v.allFinite())) &&
         (!in.contact.valid ||
          (in.contact.proxy.m.allFinite() && in.contact.normal.v.allFinite() && std::isfinite(in.contact.distance_m) &&
           std::isfinite(in.contact.surface_speed_m_per_s)));
}

/// The input with what must not be touched taken out, so that no number in it can poison the state.
ControlInput without_numbers(const ControlInput& in, const Point<HapticBase>& device) noexcept {
  ControlInput out;
  out.device = device;
  out.hand = device;
  out.device_age_s = out.hand_age_s = out.contact.age_s = 1e9;
  out.rearm = in.rearm;
  return out;
}

/// Of the energy in a spring that pushes with `force_N`, what it gives out when it never gives more than `bound_N`.
double deliverable_share(double bound_N, double force_N) noexcept {
  if (force_N <= bound_N) return 1.0;
  const double share = bound_N / force_N;
  return share * (2.0 - share);
}

bool in_body(const ControlInput& in) noexcept { return in.contact.valid && in.contact.in_body; }

bool stale(const ControlInput& in, const AgeLimits& ages) noexcept {
  // Written so that an age that is not a number counts as stale; and a sample from the future, which would never age.
  const bool hand_is_fresh = in.hand_age_s <= ages.tracker_s && in.hand_age_s >= -ages.tracker_s;
  return !(in.hand_valid && hand_is_fresh && in.contact.age_s <= ages.surface_s);
}

}  // namespace

/// Of finite inputs: numbers that are none are told apart before. The limiter's own latch ends with the re-arming.
FaultCause EncounteredController::standing_fault(const ControlInput& in) const noexcept {
  return in.device_age_s <= settings_.ages.device_s ? FaultCause::None : FaultCause::DeviceSilent;
}

/// What the phases care of. `stands`: a cause that would fault this very tick.
Seen EncounteredController::seen_of(const ControlInput& in, FaultCause stands) const noexcept {
  const double hand_m = in.hand.m.y();
  const double device_m = in.device.m.y();
  const double risen_m = settings_.transitions.hand_rose_m;
  return {.fault_stands = stands != FaultCause::None,
          .fault_latched = limiter_.faulted(),
          .rearm = in.rearm,
          .inputs_stale = stale(in, settings_.ages),
          .in_body = in_body(in),
          .surface_near = in.contact.valid && in.contact.distance_m < settings_.transitions.from_body_within_m,
          .below_plane = device_m<plane_height_m_, .at_plane = device_m >= plane_height_m_ + settings_.plane.offset_m,
                                  .hand_rose = hand_m>
                                 plane_height_m_ +
                             risen_m &&
                         hand_m > device_m + risen_m,
          .touch = effects_.touch()};
}

/// The plane stays above the skin below the end-effector, without ever stepping.
void EncounteredController::move_plane(const ControlInput& in, double dt_s) noexcept {
  double wanted_m = settings_.plane.height_m;
  if (in.contact.valid) {
    const double skin_m = in.device.m.y() - in.contact.distance_m * in.contact.normal.v.y();
    wanted_m = std::max(wanted_m, skin_m + settings_.plane.clearance_m);
  }
  if (!plane_placed_) plane_height_m_ = wanted_m;
  plane_placed_ = true;
  const double most_m = settings_.plane.speed_m_per_s * dt_s;
  plane_height_m_ += std::clamp(wanted_m - plane_height_m_, -most_m, most_m);
}

void EncounteredController::enter(Phase phase, const ControlInput& in) noexcept {
  if (!(is_inside(phase) && is_inside(phase_))) in_phase_s_ = 0.0;  // the dwell in the body counts its parts together
  phase_ = phase;
  if (phase != Phase::OutBody) return;
  // S1 eq. (5): the target starts where the end-effector is, and as fast, so that position control begins at no force.
  hand_ = {in.hand.m, in.hand_velocity.v};
  hand_.per_s.y() = 0.0;
  const Vector3d goal{in.hand.m.x(), plane_height_m_ + settings_.plane.offset_m, in.hand.m.z()};
  offset_ = {in.device.m - goal, in.device_velocity.v - hand_.per_s};
  position_force_N_.setZero();
}

/// A contact that begins at some depth, because the skin came up or the station was not ready, has not been paid for by
/// the hand's work. The skin is shown at the device first and then rises, as a patient's would.
void EncounteredController::sink_in(ControlInput& in, bool begins, double dt_s) noexcept {
  if (begins) unpaid_depth_m_ = std::max(0.0, -in.contact.distance_m);
  rising_m_per_s_ = 0.0;
  if (unpaid_depth_m_ <= 0.0) return;
  const double speed = std::clamp(unpaid_depth_m_ / kSinkInEases_s, kSinkInSlowest_m_per_s, kSinkIn_m_per_s);
  const double shown_m = std::min(unpaid_depth_m_, speed * dt_s);
  rising_m_per_s_ = shown_m / std::max(dt_s, 1e-9);
  unpaid_depth_m_ -= shown_m;
  in.contact.proxy.m -= unpaid_depth_m_ * in.contact.normal.v;
  in.contact.distance_m += unpaid_depth_m_;
  in.contact.surface_speed_m_per_s += rising_m_per_s_;
}

/// What the effects are told: seen from the body, which is shown lower by what is unpaid with all that is in it, so
/// that a contact which begins within an inner object has not that object's energy to give.
effects::EffectInput EncounteredController::as_the_body_sees(const ControlInput& in) const noexcept {
  const Vector3d& normal = in.contact.normal.v;
  effects::EffectInput felt{in.device, in.device_velocity, in.contact, {}};
  felt.device.m += unpaid_depth_m_ * normal;
  felt.device_velocity.v -= rising_m_per_s_ * normal;
  felt.contact.proxy.m += unpaid_depth_m_ * normal;
  felt.contact.surface_speed_m_per_s -= rising_m_per_s_;
  return felt;
}

void EncounteredController::begin_contact(const ControlInput& in) noexcept {
  const effects::EffectInput felt = as_the_body_sees(in);
  effects_.begin(felt);
  coupling_.begin(felt.device);
  last_felt_ = felt.device;
  passivity_.begin(0.0);
  withheld_N_.setZero();
}

Vector3d EncounteredController::effects_force_N(const ControlInput& in, double dt_s) noexcept {
  effects::EffectInput felt = as_the_body_sees(in);
  felt.moved.v = felt.device.m - last_felt_.m;
  last_felt_ = felt.device;
  Force<HapticBase> force;
  Exchange exchange;
  if (coupling_.engaged()) {
    force = coupling_.pull(effects_.step(coupling_.at_tool(felt), dt_s, cost_clock_));
    exchange.absorbed_J = coupling_.absorbed_J();
    exchange.stored_J = coupling_.energy_J();
  } else {
    force = effects_.step(felt, dt_s, cost_clock_);
  }
  exchange.absorbed_J += effects_.absorbed_J();
  exchange.stored_J += effects_.energy_J();
  const Vector3d skin_velocity = felt.contact.surface_speed_m_per_s * felt.contact.normal.v;
  exchange.velocity = {felt.device_velocity.v - skin_velocity};
  exchange.moved = {felt.moved.v - skin_velocity * dt_s};
  exchange.absorbed_J -= withheld_N_.dot(exchange.moved.v);
  // Short of the bound before the damping is added, which could not take anything back from beyond it.
  const double bound_N = limiter_.bound_N();
  const Vector3d shown_N = at_most(force.N, bound_N);
  withheld_N_ = shown_N - force.N;
  exchange.stored_J *= deliverable_share(bound_N, force.N.norm());
  damping_ = passivity_.step(exchange, dt_s);
  return shown_N + damping_.N;
}

/// Out body: proportional-derivative control to eq. (5)'s target, over the hand's x and z, on the plane.
Vector3d EncounteredController::position_force_N(const ControlInput& in, double dt_s) noexcept {
  const PositionControlSettings& pd = settings_.position;
  constexpr double w = kHandSmoothing_rad_per_s;
  Moving error{hand_.m - in.hand.m, hand_.per_s - in.hand_velocity.v};
  approach_zero(error, w, dt_s);
  hand_.per_s = at_most(in.hand_velocity.v + error.per_s, pd.fastest_m_per_s);
  const Vector3d step = in.hand.m + in.hand_velocity.v * dt_s + error.m - hand_.m;
  hand_.m += at_most(step, pd.fastest_m_per_s * dt_s);
  approach_zero(offset_, 1.0 / settings_.transitions.offset_fade_s, dt_s);
  target_.m = Vector3d{hand_.m.x(), plane_height_m_ + settings_.plane.offset_m, hand_.m.z()} + offset_.m;
  const Vector3d speed = Vector3d{hand_.per_s.x(), 0.0, hand_.per_s.z()} + offset_.per_s;
  const Vector3d wanted_N =
      at_most(pd.stiffness_N_per_m * (target_.m - in.device.m) + pd.damping_N_s_per_m * (speed - in.device_velocity.v),
              pd.most_N);
  position_force_N_ += at_most(wanted_N - position_force_N_, kPositionSlew_N_per_s * dt_s);
  return position_force_N_;
}

/// Body to plane: "a force is applied to the end-effector in order to go farther from the body". A speed is asked
/// for, so that an end-effector without a hand neither flies off nor rises past the plane while the dwell lasts.
Vector3d EncounteredController::lift_force_N(const ControlInput& in) const noexcept {
  const PositionControlSettings& lift = settings_.position;
  constexpr double kBrakes_s = 0.05;
  constexpr double kBeyond_m = 0.002;  // aims a little past the plane, to arrive
  const double left_m = plane_height_m_ + settings_.plane.offset_m + kBeyond_m - in.device.m.y();
  const double speed = std::clamp(left_m / kBrakes_s, -lift.lift_speed_m_per_s, lift.lift_speed_m_per_s);
  const Vector3d wanted = Vector3d::UnitY() * speed;
  return at_most(lift.lift_damping_N_s_per_m * (wanted - in.device_velocity.v), lift.lift_most_N);
}

/// `raw_N` plus what is left of the force before the last break. With `starts_anew`, the break is now.
Vector3d EncounteredController::faded_N(const Vector3d& raw_N, bool starts_anew, double dt_s) noexcept {
  if (starts_anew) fading_N_ = wanted_N_ - raw_N;
  const double rate =
      has_let_go(phase_) ? settings_.limits.peak_N / kReleaseWithin_s : settings_.transitions.force_fade_N_per_s;
  const double left = fading_N_.norm() - rate * dt_s;
  fading_N_ = left > 0.0 ? at_most(fading_N_, left) : Vector3d::Zero().eval();
  return raw_N + fading_N_;
}

/// S1 II.E: on the proxy in the body, as tracked out of it; the difference at a change fades.
Point<HapticBase> EncounteredController::shown_hand(const ControlInput& in, double dt_s) noexcept {
  const bool from_proxy = is_inside(phase_);
  if (in.contact.valid) last_proxy_ = in.contact.proxy;
  const Vector3d base = from_proxy ? last_proxy_.m : (in.hand_valid ? in.hand.m : shown_.m);
  if (from_proxy != shown_from_proxy_) shown_offset_m_ = shown_.m - base;
  shown_from_proxy_ = from_proxy;
  if (!from_proxy && !in.hand_valid) shown_offset_m_.setZero();
  shown_offset_m_ *= std::exp(-dt_s / settings_.transitions.offset_fade_s);
  shown_.m = base + shown_offset_m_;
  return shown_;
}

void EncounteredController::rearm() noexcept {
  limiter_.rearm();
  fault_ = FaultCause::None;
}

ControlOutput EncounteredController::step(const ControlInput& given, double dt_given_s) noexcept {
  const double dt_s = std::isfinite(dt_given_s) ? std::clamp(dt_given_s, 0.0, 0.01) : 0.0;
  const bool finite = is_finite(given);
  ControlInput in = finite ? given : without_numbers(given, target_);
  ControlOutput out;
  out.previous = phase_;

  in_phase_s_ += dt_s;
  move_plane(in, dt_s);
  const FaultCause stands = finite ? standing_fault(in) : FaultCause::NotFinite;
  const Seen seen = seen_of(in, stands);
  // The dwell of a station that let go is one of good inputs: an age that swings about its limit makes no loop.
  if (phase_ == Phase::Released && seen.inputs_stale) in_phase_s_ = 0.0;
  if (const std::optional<Event> event = event_in(phase_, seen)) {
    const Row* row = transition(phase_, *event);
    if (row != nullptr && (!row->waits_for_dwell || in_phase_s_ >= settings_.transitions.dwell_s)) {
      if (*event == Event::Fault) fault_ = stands != FaultCause::None ? stands : FaultCause::NotFinite;
      if (*event == Event::Rearm) rearm();
      enter(row->to, in);
      out.event = *event;
    }
  }

  const bool touching = in_body(in) && (is_inside(phase_) || phase_ == Phase::BodyToPlane);
  const bool contact_changed = touching != touching_;
  if (touching) sink_in(in, !touching_, dt_s);
  if (touching && !touching_) begin_contact(in);
  touching_ = touching;
  damping_ = {};
  target_ = in.device;
  Vector3d raw_N = touching ? effects_force_N(in, dt_s) : Vector3d::Zero().eval();
  if (phase_ == Phase::BodyToPlane && !touching) raw_N += lift_force_N(in);  // in the skin, the skin itself lifts
  if (phase_ == Phase::OutBody) raw_N += position_force_N(in, dt_s);
  const bool outer_change = phase_ != out.previous && !(is_inside(phase_) && is_inside(out.previous));
  wanted_N_ = faded_N(raw_N, outer_change || contact_changed, dt_s);

  out.phase = phase_;
  out.force = limiter_.limit({wanted_N_}, dt_s);
  withheld_N_ += out.force.N - wanted_N_;
  out.limited = limiter_.limited() || (touching && withheld_N_.squaredNorm() > 1e-18);
  out.fault = fault_;
  out.fault_stands = stands;
  out.target = target_;
  out.displayed_hand = shown_hand(in, dt_s);
  if (touching) out.indentation = effects_.indentation();
  out.plane_height_m = plane_height_m_;
  out.passivity_J = passivity_.balance_J();
  out.damping = damping_;
  out.surface_speed_m_per_s = in.contact.surface_speed_m_per_s;
  return out;
}

}  // namespace telepalp::control
