#include "haptic_station/loop/device_gate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace telepalp::loop {
namespace {

using Eigen::Vector3d;

constexpr double kSpeedFilter_rad_per_s = 2.0 * std::numbers::pi * 150.0;
constexpr double kHoldDecay_s = 0.005;  // time constant with which the last velocity decays during extrapolation
// After a longer silence the next reading is accepted as it is. So it is after an interruption of the haptic thread that
// was longer than the time that the loop catches up, 10.5 ms: the device has moved on for an unknown time.
constexpr double kLongestGap_s = 0.01;
constexpr double kSpeedTolerance_m_per_s = 0.05;
constexpr double kSpeedToleranceShare = 0.3;
constexpr double kMostAcceleration_m_per_s2 = 300.0;  // of an end-effector that a hand holds
constexpr double kEncoderNoise_m = 0.05e-3;
constexpr double kTimingError = 0.5;  // relative error of the time between two readings
constexpr double kSlip_m = 0.005;  // a lasting offset (slip) up to this is removed slowly; a larger one is implausible
constexpr double kBelievedAfter_s = 0.001;  // after a jump, readings consistent for this long show a lasting offset
constexpr double kRebasedAfter_s =
    0.5;  // after a larger offset, readings consistent for this long are accepted unchanged
constexpr double kAbsorbedOver_s = 0.02;    // time constant of the removal of an offset
constexpr double kAbsorbed_m_per_s = 0.15;  // fastest removal of an offset: 0.04 N per tick on a skin of 500 N/m

bool is_finite(const ports::DeviceReading& reading) noexcept {
  return reading.at.m.allFinite() && reading.velocity.v.allFinite() && std::isfinite(reading.age_s);
}

}  // namespace

double DeviceGate::allowed_m(double speed_m_per_s, double since_s) const noexcept {
  return kEncoderNoise_m + kTimingError * speed_m_per_s * since_s + kMostAcceleration_m_per_s2 * since_s * since_s;
}

void DeviceGate::start(const ports::DeviceReading& reading) noexcept {
  at_m_ = reading.at.m;
  speed_ = raw_speed_ = reading.velocity.v;
  offset_m_.setZero();
  implausible_s_ = unreadable_s_ = agree_s_ = 0.0;
  last_ = reading;
  started_ = true;
}

void DeviceGate::accept(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept {
  const double offset_m = offset_m_.norm();
  if (offset_m > 0.0) {
    const double absorbed_m = std::min(offset_m * dt_s / kAbsorbedOver_s, kAbsorbed_m_per_s * dt_s);
    offset_m_ *= offset_m < 1e-7 ? 0.0 : 1.0 - absorbed_m / offset_m;
  }
  const Vector3d at_m = reading.at.m + offset_m_;
  speed_ += ((at_m - at_m_) / since_s - speed_) * (1.0 - speed_left_.of(-kSpeedFilter_rad_per_s * since_s));
  at_m_ = at_m;
  implausible_s_ = 0.0;
}

/// Moves on with the last velocity, which decays.
void DeviceGate::go_on(double dt_s) noexcept {
  at_m_ += speed_ * dt_s;
  speed_ *= std::exp(-dt_s / kHoldDecay_s);
}

/// Without any earlier reading, the position is zero and counts as unreadable for ever.
GatedReading DeviceGate::bridge(double dt_s) noexcept {
  const double part_s = dt_s > 0.0 ? dt_s : 0.0;
  if (started_) go_on(part_s);
  unreadable_s_ += part_s;
  return {.at = {at_m_},
          .velocity = {speed_},
          .implausible_s = implausible_s_,
          .unreadable_s = started_ ? unreadable_s_ : std::numeric_limits<double>::infinity()};
}

/// Takes the first finite reading after a bridge. If the extrapolated position is within kSlip_m of it, the position
/// goes on from there, and the offset is removed slowly.
void DeviceGate::come_back(const ports::DeviceReading& reading, double since_s, double dt_s) noexcept {
  unreadable_s_ = 0.0;
  agree_s_ = 0.0;  // one reading shows no agreement yet
  raw_speed_ = (reading.at.m - last_.at.m) / since_s;
  if ((at_m_ + speed_ * dt_s - reading.at.m).norm() > kSlip_m) return hold(reading, dt_s);
  go_on(dt_s);
  offset_m_ = at_m_ - reading.at.m;
  speed_ = raw_speed_;
}

/// Handles a reading after a jump. Readings that agree with each other are accepted again. If they differ little from
/// the extrapolated position, this offset remains and is removed slowly. If they differ more, they are accepted without
/// an offset, but only after kRebasedAfter_s.
void DeviceGate::hold(const ports::DeviceReading& reading, double dt_s) noexcept {
  if (implausible_s_ <= 0.0) ++jumps_;
  implausible_s_ += dt_s;
  go_on(dt_s);
  const Vector3d slip_m = at_m_ - reading.at.m;
  if (agree_s_ >= kRebasedAfter_s) return start(reading);
  if (agree_s_ < kBelievedAfter_s || slip_m.norm() > kSlip_m) return;
  offset_m_ = slip_m;
  speed_ = raw_speed_;
  implausible_s_ = 0.0;
}

GatedReading DeviceGate::answer(const ports::DeviceReading& reading) const noexcept {
  const double wrong = (reading.velocity.v - speed_).norm();
  const bool believed =
      implausible_s_ <= 0.0 && wrong <= kSpeedTolerance_m_per_s + kSpeedToleranceShare * speed_.norm();
  return {.at = {at_m_}, .velocity = {believed ? reading.velocity.v : speed_}, .implausible_s = implausible_s_};
}

GatedReading DeviceGate::step(const ports::DeviceReading& reading, double dt_s) noexcept {
  if (!is_finite(reading)) return bridge(dt_s);
  if (!(dt_s > 0.0)) return {.at = reading.at, .velocity = reading.velocity, .implausible_s = implausible_s_};
  const double since_s = unreadable_s_ + dt_s + last_.age_s - reading.age_s;  // time between the last two readings
  if (!started_ || !(since_s < kLongestGap_s)) {
    start(reading);
    return answer(reading);
  }
  if (since_s <= 0.0 ||
      (reading.age_s > last_.age_s && reading.at.m == last_.at.m)) {  // the device gave no new reading
    last_.age_s = reading.age_s;
    unreadable_s_ = 0.0;
    return answer(reading);
  }
  if (unreadable_s_ > 0.0) {
    come_back(reading, since_s, dt_s);
    last_ = reading;
    return answer(reading);
  }
  const Vector3d raw_speed = (reading.at.m - last_.at.m) / since_s;
  const bool agrees = (raw_speed - raw_speed_).norm() * since_s <= allowed_m(raw_speed_.norm(), since_s);
  agree_s_ = agrees ? agree_s_ + dt_s : 0.0;
  raw_speed_ = raw_speed;
  last_ = reading;
  const double surprise_m = (reading.at.m + offset_m_ - at_m_ - speed_ * since_s).norm();
  if (surprise_m <= allowed_m(speed_.norm(), since_s))
    accept(reading, since_s, dt_s);
  else
    hold(reading, dt_s);
  return answer(reading);
}

}  // namespace telepalp::loop
