#include "haptic_station/loop/attitude_gate.h"

#include "proto/words/wrench.h"

namespace telepalp::loop {
namespace {

constexpr double kLongestBridge_s = 0.02;
constexpr double kFastest_rad_per_s = 40.0;
constexpr double kNoise_rad = 0.02;

bool is_rotation(const Eigen::Quaterniond& attitude) noexcept {
  constexpr double kShortest = 0.1;
  constexpr double kLongest = 1e6;
  return attitude.coeffs().allFinite() && attitude.norm() > kShortest && attitude.norm() < kLongest;
}

}  // namespace

std::optional<Eigen::Quaterniond> AttitudeGate::step(const ports::DeviceReading& reading, double dt_s) noexcept {
  if (!reading.attitude) {
    bridged_s_ = 0.0;
    return last_ = std::nullopt;
  }
  const bool rotates = is_rotation(*reading.attitude);
  if (!last_ && !rotates) return std::nullopt;
  const Eigen::Quaterniond now = rotates ? reading.attitude->normalized() : *last_;
  const double most_rad = kNoise_rad + kFastest_rad_per_s * (dt_s + bridged_s_);
  const bool believed = rotates && (!last_ || turned_rad(*last_, now).norm() <= most_rad);
  if (believed) {
    bridged_s_ = 0.0;
    return last_ = now;
  }
  if (bridged_s_ <= 0.0) ++jumps_;
  bridged_s_ += dt_s;
  if (bridged_s_ <= kLongestBridge_s) return last_;
  bridged_s_ = 0.0;
  if (rotates)
    last_ = now;
  else
    last_ = std::nullopt;
  return last_;
}

}  // namespace telepalp::loop
