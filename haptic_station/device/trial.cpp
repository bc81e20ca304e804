#include "haptic_station/device/trial.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace telepalp::device {
namespace {

constexpr double kHigh = 0.07;  // height above the skin [m], higher than the plane on which the device waits
constexpr double kLow = 0.02;   // height above the skin [m] at which the hand passes this plane

constexpr std::array kIndentSeveralPoints = std::to_array<Waypoint>({
    {0.8, 0.00, kHigh, 0.00},
    {0.6, 0.00, kLow, 0.00},
    {0.8, 0.00, -0.035, 0.00},
    {0.7, 0.00, -0.035, 0.00},
    {0.9, 0.00, kHigh, 0.00},
    {0.9, 0.05, kHigh, 0.02},
    {0.6, 0.05, kLow, 0.02},
    {0.8, 0.05, -0.040, 0.02},
    {0.7, 0.05, -0.040, 0.02},
    {0.9, 0.05, kHigh, 0.02},
    {0.9, -0.05, kHigh, -0.03},
    {0.6, -0.05, kLow, -0.03},
    {0.8, -0.05, -0.030, -0.03},
    {0.7, -0.05, -0.030, -0.03},
    {0.9, -0.05, kHigh, -0.03},
});

constexpr std::array kMoveWithin = std::to_array<Waypoint>({
    {0.8, 0.06, kHigh, 0.00},
    {0.6, 0.06, kLow, 0.00},
    {1.0, 0.06, -0.030, 0.00},
    {0.5, 0.06, -0.060, 0.00},
    {0.5, 0.06, -0.030, 0.00},
    {0.8, 0.11, -0.035, 0.00},
    {0.8, 0.06, -0.035, 0.05},
    {0.8, 0.01, -0.025, 0.00},
    {0.8, 0.06, -0.035, -0.05},
    {0.8, 0.06, -0.035, 0.00},
    {1.0, 0.06, kHigh, 0.00},
});

constexpr std::array kFindCylinder = std::to_array<Waypoint>({
    {0.8, 0.00, kHigh, 0.00},
    {0.6, 0.00, kLow, 0.00},
    {1.2, 0.00, -0.060, 0.00},
    {0.8, 0.01, -0.060, 0.00},
    {0.6, 0.00, -0.025, 0.00},
    {0.9, 0.00, kHigh, 0.00},
    {0.9, 0.045, kHigh, 0.00},
    {0.6, 0.045, kLow, 0.00},
    {1.5, 0.055, -0.090, 0.00},
    {1.2, -0.010, -0.090, 0.00},
    {0.6, -0.010, -0.090, 0.00},
    {0.8, 0.060, -0.070, 0.00},
    {1.2, 0.050, kHigh, 0.00},
});

constexpr std::array kFreeSearch = std::to_array<Waypoint>({
    {0.8, -0.07, kHigh, -0.04},
    {0.5, -0.07, kLow, -0.04},
    {0.8, -0.07, -0.050, -0.04},
    {0.8, -0.04, -0.055, -0.03},
    {0.9, -0.07, kHigh, -0.04},
    {0.9, 0.06, kHigh, 0.05},
    {0.5, 0.06, kLow, 0.05},
    {0.8, 0.06, -0.055, 0.05},
    {0.9, 0.03, -0.065, 0.03},
    {0.9, 0.06, kHigh, 0.05},
    {0.9, 0.01, kHigh, 0.00},
    {0.5, 0.01, kLow, 0.00},
    {1.3, 0.01, -0.060, 0.00},
    {0.8, 0.01, -0.030, 0.00},
    {0.8, 0.01, -0.060, 0.00},
    {1.0, 0.01, kHigh, 0.00},
});

/// Ends at the height at which it begins, as S1's trials do. At most 40 mm/s inside the body.
constexpr std::array kInsertNeedle = std::to_array<Waypoint>({
    {0.6, 0.00, kHigh, 0.00},
    {0.5, 0.00, kLow, 0.00},
    {3.0, 0.00, -0.055, 0.00},
    {1.2, 0.00, -0.055, 0.00},
    {2.0, 0.00, kLow, 0.00},
    {2.2, 0.00, -0.045, 0.00},
    {0.5, 0.00, -0.045, 0.00},
    {2.2, 0.00, kHigh, 0.00},
    {0.9, 0.03, kHigh, 0.01},
    {0.5, 0.03, kLow, 0.01},
    {3.0, 0.03, -0.055, 0.01},
    {0.5, 0.03, -0.055, 0.01},
    {2.2, 0.03, kHigh, 0.01},
});

/// Against objects whose sides are 30 mm from the middle. At most 100 mm/s. The arm yields, so the hand is less deep in
/// the skin.
constexpr std::array kPushSideways = std::to_array<Waypoint>({
    {0.8, 0.000, kHigh, 0.00},
    {0.6, 0.000, kLow, 0.00},
    {1.0, 0.000, -0.035, 0.00},
    {1.0, -0.045, -0.035, 0.00},
    {0.4, -0.045, -0.035, 0.00},
    {1.0, 0.000, -0.035, 0.00},
    {1.0, 0.045, -0.035, 0.00},
    {0.4, 0.045, -0.035, 0.00},
    {1.0, 0.000, -0.035, 0.00},
    {0.9, -0.045, -0.035, 0.00},
    {0.9, 0.000, -0.035, 0.00},
    {0.9, 0.045, -0.035, 0.00},
    {0.9, 0.000, -0.035, 0.00},
    {1.0, 0.000, kHigh, 0.00},
});

struct Leg {
  const Waypoint* from;
  const Waypoint* to;
  double share;  ///< 0 at `from`, 1 at `to`
};

Leg leg_at(std::span<const Waypoint> script, double time_s) noexcept {
  double total_s = 0.0;
  for (const Waypoint& waypoint : script) total_s += waypoint.seconds;
  double left_s = std::fmod(std::max(time_s, 0.0), total_s);
  const Waypoint* from = &script.back();  // a repeated trial starts where it ended
  for (const Waypoint& waypoint : script) {
    if (left_s < waypoint.seconds) return {from, &waypoint, left_s / waypoint.seconds};
    left_s -= waypoint.seconds;
    from = &waypoint;
  }
  return {from, from, 1.0};
}

/// Minimum jerk: people's reaching movements (Flash and Hogan 1985).
double minimum_jerk(double s) noexcept { return s * s * s * (10.0 + s * (-15.0 + 6.0 * s)); }
double minimum_jerk_rate(double s) noexcept { return s * s * (30.0 + s * (-60.0 + 30.0 * s)); }

Eigen::Vector3d offset_m(const Waypoint& waypoint) noexcept { return {waypoint.x_m, waypoint.height_m, waypoint.z_m}; }

}  // namespace

std::span<const Waypoint> waypoints(Trial trial) noexcept {
  switch (trial) {
    case Trial::IndentSeveralPoints:
      return kIndentSeveralPoints;
    case Trial::MoveWithin:
      return kMoveWithin;
    case Trial::FindCylinder:
      return kFindCylinder;
    case Trial::FreeSearch:
      return kFreeSearch;
    case Trial::InsertNeedle:
      return kInsertNeedle;
    case Trial::PushSideways:
      return kPushSideways;
  }
  return kIndentSeveralPoints;
}

double duration_s(Trial trial) noexcept {
  double sum_s = 0.0;
  for (const Waypoint& waypoint : waypoints(trial)) sum_s += waypoint.seconds;
  return sum_s;
}

Intention ScriptedIntention::step(const TrialView& view, double dt_s) noexcept {
  constexpr double kLearns_s = 0.7;
  if (view.contact.valid) {
    const double skin_m = view.device.m.y() - view.contact.distance_m * view.contact.normal.v.y();
    skin_height_m_ += (skin_m - skin_height_m_) * (1.0 - std::exp(-dt_s / kLearns_s));
  }
  const Leg leg = leg_at(script_, view.time_s);
  const Eigen::Vector3d start = offset_m(*leg.from);
  const Eigen::Vector3d way = offset_m(*leg.to) - start;
  const Eigen::Vector3d origin{center_.m.x(), skin_height_m_, center_.m.z()};
  return {.at = {origin + start + way * minimum_jerk(leg.share)},
          .velocity = {way * minimum_jerk_rate(leg.share) / leg.to->seconds}};
}

}  // namespace telepalp::device
