#include <cmath>
#include <numbers>

#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/studies.h"

// A colleague's arm lies over a quarter of the image, beside the pressed place, while the patient sits up, coughs or
// shifts. The station sees less of the body than without the arm. This study divides its force error by that of the
// same run without the arm.

namespace telepalp::bench::hand {
namespace {

constexpr double kComes_s = 6.0;
constexpr int kJudgedEvery = 4;         // judges each fourth tick
constexpr double kArmBeside_px = 80.0;  // from the pressed place to the arm's middle: 50 px, 75 mm, to its side
constexpr double kPalm_px = -120.0;     // from the image's middle: the forearm crosses the whole image
constexpr double kPalmOver_m = 0.06;    // height of the palm's underside over the skin
constexpr double kArmAway_m = 0.8;      // at this distance from its place, the arm is outside the image
constexpr double kArm_m_per_s = 0.3;
constexpr double kCovers_m = 0.015;  // where the arm makes the depth smaller by more, it covers the pixel

/// The arm over the patient in `pose`: it has come from the head's side by kComes_s + 2.7 s, and rides on the body.
capture::ColleagueHand arm_at(const capture::SyntheticPatient& patient, const capture::PatientPose& pose,
                              const Spot& spot, double time_s) {
  const Intrinsics& camera = patient.settings().camera;
  const double beside_px = spot.v > 0.0 ? -kArmBeside_px : kArmBeside_px;
  capture::ColleagueHand hand{.heading_rad = std::numbers::pi, .arm_rise_rad = 0.25, .lifts = {}};
  hand.under_palm_m = patient.surface_of(pose).at_pixel(camera.cx + kPalm_px, camera.cy + spot.v + beside_px).at.m;
  hand.under_palm_m.z() -= kPalmOver_m;
  hand.under_palm_m.x() += std::max(0.0, kArmAway_m - kArm_m_per_s * (time_s - kComes_s));
  return hand;
}

PoseScript with_arm(const PoseScript& pose, std::shared_ptr<const capture::SyntheticPatient> patient,
                    const Spot& spot) {
  return [=](double t) {
    capture::PatientPose now = pose(t);
    if (t >= kComes_s) now.colleague = arm_at(*patient, now, spot, t);
    return now;
  };
}

/// The share of the image that the arm covers while the patient is at rest.
double covered_share(const capture::SyntheticPatient& patient, const Spot& spot) {
  capture::PatientPose pose;
  const DepthImage bare = patient.depth_of(pose, at_time(0.0));
  pose.colleague = arm_at(patient, pose, spot, kUntil_s);
  const DepthImage seen = patient.depth_of(pose, at_time(0.0));
  double covered = 0.0;
  for (std::size_t i = 0; i < seen.samples.size(); ++i)
    if (seen.samples[i] > 0 && bare.unit_m * bare.samples[i] - seen.unit_m * seen.samples[i] > kCovers_m)
      covered += 1.0;
  return covered / static_cast<double>(seen.samples.size());
}

/// Mean squares of the force error [N2] of the stations at all delays and anchors; NaN without contact.
std::vector<double> errors_N2(const Pattern& pattern, const Spot& spot, bool arm) {
  const auto patient = torso();
  const PoseScript bare = script(pattern, patient, spot);
  Feed feed({.patient = patient,
             .pose = arm ? with_arm(bare, patient, spot) : bare,
             .link = link_before_delays(),
             .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const auto path = [&](double t, const control::ControlOutput&) {
    const double height_m = reaching_m(t, kDepth_m) + ridden_m(pattern, bare, *patient, placed, t);
    return Point<HapticBase>{{0.0, height_m, 0.0}};
  };
  std::vector<DelayedStation> stations = stations_at_delays(placed, [&] { return std::make_unique<RigidHand>(path); });
  std::vector<double> squares_N2(stations.size(), 0.0);
  std::vector<double> touched_s(stations.size(), 0.0);
  double count = 0.0;
  run_together(feed, stations, kUntil_s, [&](std::size_t index, const Tick& tick) {
    if (tick.time_s < kFrom_s || std::llround(tick.time_s / kTick_s) % kJudgedEvery != 0) return;
    const double off_N = tick.pushed_N() - tick.law_N();
    squares_N2[index] += off_N * off_N;
    touched_s[index] += tick.displayed ? kJudgedEvery * kTick_s : 0.0;
    count += index == 0 ? 1.0 : 0.0;
  });
  for (std::size_t i = 0; i < stations.size(); ++i)
    squares_N2[i] = touched_s[i] > 0.5 * (kUntil_s - kFrom_s) ? squares_N2[i] / count : NAN;
  return squares_N2;
}

/// For each delay, the worst of places and anchors: the error with the arm divided by that without.
std::vector<Row> measure_arm_over(const Pattern& pattern, const Options& options) {
  const auto places = spots();
  std::vector<std::array<std::vector<double>, 2>> all(places.size());
  for_each_parallel(static_cast<int>(2 * places.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    all[at / 2][at % 2] = errors_N2(pattern, places[at / 2], at % 2 == 1);
  });
  OfDelays worst{};
  double least_covered = 1.0;
  for (std::size_t place = 0; place < places.size(); ++place) {
    least_covered = std::min(least_covered, covered_share(*torso(), places[place]));
    for (std::size_t i = 0; i < all[place][0].size(); ++i) {
      const double ratio = std::sqrt(all[place][1][i] / all[place][0][i]);
      double& so_far = worst[i % kDelays_s.size()];
      if (!std::isnan(so_far) && !(ratio <= so_far)) so_far = ratio;
    }
  }
  const std::string name = "arm over a quarter/" + std::string(pattern.name);
  std::vector<Row> rows{
      at_least(name + ": share of the image that the arm covers, least", 100.0 * least_covered, "%", 25.0)};
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay)
    rows.push_back(
        at_most(name + ": force RMSE at a delay of " + delay_name(delay) + ", divided by that without the arm, worst",
                worst[delay], "", 1.1));
  return rows;
}

}  // namespace

std::vector<Study> arm_over() {
  std::vector<Study> studies;
  std::vector<const Pattern*> patterns{&sit_up()};
  for (const Pattern& jolt : jolts()) patterns.push_back(&jolt);
  for (const Pattern* pattern : patterns)
    studies.push_back({"arm over a quarter/" + std::string(pattern->name),
                       [pattern](const Options& options) { return measure_arm_over(*pattern, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
