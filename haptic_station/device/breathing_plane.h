#pragma once

#include <cmath>
#include <numbers>

#include "haptic_station/ports/surface_contact.h"

namespace telepalp::device {

/// A simulated patient for trials and tests: a horizontal skin at `height_m` that rises and falls as a sine.
struct BreathingPlane {
  double height_m = 0.0;
  double amplitude_m = 0.0;
  double rate_hz = 0.25;

  [[nodiscard]] double at_m(double time_s) const noexcept {
    return height_m + amplitude_m * std::sin(2.0 * std::numbers::pi * rate_hz * time_s);
  }
  [[nodiscard]] double speed_m_per_s(double time_s) const noexcept {
    const double omega = 2.0 * std::numbers::pi * rate_hz;
    return amplitude_m * omega * std::cos(omega * time_s);
  }

  ports::SurfaceContact operator()(const Point<HapticBase>& device, double time_s) const noexcept {
    const double skin_m = at_m(time_s);
    ports::SurfaceContact contact;
    contact.normal.v = Eigen::Vector3d::UnitY();
    contact.distance_m = device.m.y() - skin_m;
    contact.in_body = contact.distance_m < 0.0;
    contact.proxy = device;
    if (contact.in_body) contact.proxy.m.y() = skin_m;
    contact.valid = true;
    contact.surface_speed_m_per_s = speed_m_per_s(time_s);
    return contact;
  }
};

}  // namespace telepalp::device
