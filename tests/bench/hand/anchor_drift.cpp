#include <cmath>
#include <numbers>

#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// A hand rubs over the breathing skin, in step with the breath, for a minute, and comes back to where it first touched.
// Measures the distance there between the felt skin and the true skin.

namespace telepalp::bench::hand {
namespace {

constexpr double kSoft_N_per_m = 100.0;  // far from the anchor the force must not reach the device's peak
constexpr double kRubs_s = 60.0;
constexpr double kRubsFrom_s = 12.0;  // the breathing model has locked on by then
constexpr double kRubDepth_m = 0.012;
constexpr double kBreath_hz = 0.25;

/// Offset between the felt and the true skin at the anchor, over the last second.
double play_anchor_drift(double reach_m, const Spot& spot, double phase) {
  const auto patient = torso();
  Feed feed({.patient = patient,
             .pose = [&](double t) { return patient->pose(at_time(t)); },
             .link = {.one_way_s = 0.05, .seed = 3},
             .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const capture::TrueSurface rest = patient->surface_of({});
  const Vector<DepthCamera> up = placed.inverse() * Vector<HapticBase>{Eigen::Vector3d::UnitY()};
  const auto path = [&](double t, const control::ControlOutput&) {
    const double along_s = std::clamp(t - kRubsFrom_s, 0.0, kRubs_s);
    const double fade = eased(along_s / 2.0) * eased((kRubs_s - along_s) / 2.0);
    const double x_m = reach_m * fade * std::sin(2.0 * std::numbers::pi * (kBreath_hz * t + phase));
    const auto skin = rest.height_along(placed.inverse() * Point<HapticBase>{{x_m, 0.0, 0.0}}, up);
    const double down = eased((t - 1.0) / 1.5);
    return Point<HapticBase>{{x_m, (skin ? skin->m : 0.0) + 0.04 - (0.04 + kRubDepth_m) * down, 0.0}};
  };
  BenchStation station(with_skin(effects::SkinAnchor::FollowsSurface, kSoft_N_per_m), placed,
                       std::make_unique<RigidHand>(path));
  double off_m = 0.0;
  int ticks = 0;
  int lost = 0;
  run(feed, station, kRubsFrom_s + kRubs_s + 3.0, [&](const Tick& tick) {
    if (tick.time_s < kRubsFrom_s + kRubs_s + 1.0) return;
    off_m += tick.pushed_N() / kSoft_N_per_m - tick.true_depth_m;
    ++ticks;
    if (!tick.displayed) ++lost;
  });
  return lost > 0 ? std::numeric_limits<double>::infinity() : std::abs(off_m / ticks);
}

std::vector<Row> measure_anchor_drift(const std::string& name, double reach_m, const Options& options) {
  struct Cell {
    Spot spot;
    double phase;
  };
  const Cell cells[] = {{spots()[0], 0.0}, {spots()[0], 0.25}, {spots()[2], 0.0}, {spots()[2], 0.25}};
  double off_m[std::size(cells)] = {};
  for_each_parallel(static_cast<int>(std::size(cells)), options, [&](int i) {
    const Cell& cell = cells[static_cast<std::size_t>(i)];
    off_m[i] = play_anchor_drift(reach_m, cell.spot, cell.phase);
  });
  return {at_most(name + ": distance of the felt skin from the true skin after 60 s, worst",
                  1e3 * *std::max_element(std::begin(off_m), std::end(off_m)), "mm", 1.0)};
}

}  // namespace

std::vector<Study> anchor_drift() {
  std::vector<Study> studies;
  for (const int reach_mm : {20, 50}) {
    const std::string name = "drift/rubbing " + std::to_string(reach_mm) + " mm";
    studies.push_back({name, [name, reach_mm](const Options& options) {
                         return measure_anchor_drift(name, 1e-3 * reach_mm, options);
                       }});
  }
  return studies;
}

}  // namespace telepalp::bench::hand
