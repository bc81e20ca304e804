#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/studies.h"

// A colleague's hand comes into the picture, lies on the skin or hovers over it, moves its fingers, and leaves, while
// the doctor presses, rests on the skin or waits above it. Each run is compared with the same run without this hand.

namespace telepalp::bench::hand {
namespace {

constexpr double kPressed_s = 2.0;  // the doctor's hand has arrived by then
constexpr double kVisitBegins_s = 6.0;
constexpr double kAfterVisit_s = 4.0;  // time after the visit for which the run goes on

/// What the visit changed for the doctor, against the same run without it.
struct VisitCost {
  double outwards_m = 0.0;         ///< most by which the device is farther out
  double force_N = 0.0;            ///< most by which the device pushes harder along the skin's normal
  double work_mJ = 0.0;            ///< most by which the device has done more work on the hand since the visit began
  double work_there_mJ = 0.0;      ///< the same, until the hand begins to leave
  double work_returning_mJ = 0.0;  ///< from then on: most work beyond that of the true skin's law on the same path. The
                                   ///< hand has sunk in while the skin was not felt, and the skin pushes it back
  double again_s = 0.0;            ///< from the first image without the hand until the force is 90 % of the law's
};

enum class Doctor { Presses, Rests, Waits };

struct DrawnVisit {
  DrawnVisit(Doctor doctor, int number)
      : seed(static_cast<std::uint64_t>(number) + 1),
        random(31000 + seed),
        spot(spots()[random.bits() % spots().size()]),
        anchor(number % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding),
        breath_begins_s(random.uniform(0.0, 900.0)),
        one_way_s(random.uniform(0.0, 0.15)),
        force_N(doctor == Doctor::Presses ? random.uniform(1.0, 5.0) : random.uniform(0.2, 0.5)),
        height_m(doctor == Doctor::Waits ? random.uniform(0.011, 0.05) : -aim_depth_m(force_N)) {
    const Intrinsics& camera = patient->settings().camera;
    constexpr double kBeside_px = 20.0;  // 30 mm
    visit.place = patient->surface_of({})
                      .at_pixel(camera.cx + spot.u + random.uniform(-kBeside_px, kBeside_px),
                                camera.cy + spot.v + random.uniform(-kBeside_px, kBeside_px))
                      .at;
    visit.over_m = number % 3 == 0 ? 0.0 : random.uniform(0.02, 0.09);
    visit.from_above = number % 2 == 1;
    visit.heading_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
    visit.arm_rise_rad = random.uniform(0.15, 0.5);
    visit.fingers_hz = random.uniform(0.5, 2.0);
    visit.begins_s = kVisitBegins_s;
  }

  /// The depth at which a hand on its arm must aim to press the skin with `force_N`.
  [[nodiscard]] static double aim_depth_m(double force_N) noexcept {
    return force_N * (1.0 / kArm_N_per_m + 1.0 / kSkin_N_per_m);
  }
  [[nodiscard]] capture::PatientPose pose(double time_s, bool visited) const {
    capture::PatientPose pose = patient->pose(at_time(breath_begins_s + time_s));
    if (visited) pose.colleague = visit.at(time_s, patient->surface_of({}), patient->surface_of(pose));
    return pose;
  }
  [[nodiscard]] std::unique_ptr<Person> person() const {
    const Eigen::Vector3d normal = normal_at(*patient, spot).v;
    return std::make_unique<ArmHand>(kArm_N_per_m, [normal, height = height_m](double t) {
      const double share = eased((t - 0.9) / (kPressed_s - 0.9));
      return device::Intention{{(0.06 + share * (height - 0.06)) * normal}, {}};
    });
  }

  std::uint64_t seed;
  device::Random random;
  std::shared_ptr<const capture::SyntheticPatient> patient = torso(Sensor::Kinect, capture::Motion::Irregular);
  Spot spot;
  effects::SkinAnchor anchor;
  double breath_begins_s;
  double one_way_s;
  double force_N;
  double height_m;  ///< of the doctor's aim over the skin at rest
  capture::ColleagueVisit visit;
};

/// One tick of one of the two runs.
struct VisitedTick {
  Eigen::Vector3d device_m;
  double pushed_N;
  double law_N;
  double work_mJ;    ///< of the device on the hand since the visit began
  double beyond_mJ;  ///< the same, less the work of the true skin's law on the same path
};

struct Played {
  std::vector<VisitedTick> ticks;  ///< from the beginning of the visit on
  double first_without_s = 0.0;    ///< time at which the first image after the visit arrived
  double step_N = 0.0;
};

Played play_colleague(const DrawnVisit& drawn, bool visited) {
  Feed feed({.patient = drawn.patient,
             .pose = [&drawn, visited](double t) { return drawn.pose(t, visited); },
             .link = {.one_way_s = drawn.one_way_s, .seed = drawn.seed},
             .builder = {}});
  StationSettings settings = with_skin(drawn.anchor);
  settings.seed = drawn.seed;
  // Without the colleague, 5 N for 20 s would warm the motors, whose limit then yields 4 N to the hand; with the
  // colleague they stay cool. That is no effect of the visit on the skin.
  settings.control.limits.continuous_N = settings.control.limits.peak_N;
  BenchStation station(settings, haptic_from_camera(*drawn.patient, drawn.spot), drawn.person());
  Played played;
  ForceSteps steps;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d law_N = Eigen::Vector3d::Zero();
  double work_mJ = 0.0;
  double beyond_mJ = 0.0;
  run(feed, station, drawn.visit.gone_s() + kAfterVisit_s, [&](const Tick& tick) {
    if (tick.time_s >= drawn.visit.begins_s) {
      work_mJ += 1e3 * force_N.dot(tick.moved_m);
      beyond_mJ += 1e3 * (force_N - law_N).dot(tick.moved_m);
      steps.add(tick);
      played.ticks.push_back({tick.device_m, tick.pushed_N(), tick.law_N(), work_mJ, beyond_mJ});
    }
    force_N = tick.force_N;
    law_N = tick.law_N() * tick.normal;
    if (played.first_without_s == 0.0 && feed.newest_captured_s() >= drawn.visit.gone_s())
      played.first_without_s = tick.time_s;
  });
  played.step_N = steps.worst_N();
  return played;
}

VisitCost cost_of(const DrawnVisit& drawn, const Played& with, const Played& without) {
  VisitCost cost;
  const Eigen::Vector3d normal = normal_at(*drawn.patient, drawn.spot).v;
  cost.again_s = drawn.height_m > 0.0 ? 0.0 : kAfterVisit_s;
  bool felt = drawn.height_m > 0.0;
  double left_mJ = 0.0;
  for (std::size_t i = 0; i < with.ticks.size(); ++i) {
    const VisitedTick& one = with.ticks[i];
    const VisitedTick& other = without.ticks[i];
    cost.outwards_m = std::max(cost.outwards_m, normal.dot(one.device_m - other.device_m));
    cost.force_N = std::max(cost.force_N, one.pushed_N - other.pushed_N);
    cost.work_mJ = std::max(cost.work_mJ, one.work_mJ - other.work_mJ);
    const double since_s = drawn.visit.begins_s + static_cast<double>(i) * kTick_s - with.first_without_s;
    if (since_s + with.first_without_s < drawn.visit.leaves_s()) {
      cost.work_there_mJ = std::max(cost.work_there_mJ, one.work_mJ - other.work_mJ);
      left_mJ = one.beyond_mJ;
    }
    cost.work_returning_mJ = std::max(cost.work_returning_mJ, one.beyond_mJ - left_mJ);
    if (felt || since_s < 0.0) continue;
    felt = one.law_N > 0.0 && one.pushed_N >= 0.9 * one.law_N;
    cost.again_s = since_s;
  }
  return cost;
}

std::vector<Row> measure_colleague(const std::string& name, Doctor doctor, const Options& options) {
  std::vector<VisitCost> all(static_cast<std::size_t>(options.seeds));
  std::vector<double> steps_N(all.size());
  for_each_parallel(options.seeds, options, [&](int i) {
    const DrawnVisit drawn(doctor, i);
    const Played with = play_colleague(drawn, true);
    all[static_cast<std::size_t>(i)] = cost_of(drawn, with, play_colleague(drawn, false));
    steps_N[static_cast<std::size_t>(i)] = with.step_N;
  });
  const auto worst = [&](double VisitCost::*value) {
    double most = 0.0;
    for (const VisitCost& one : all) most = std::max(most, one.*value);
    return most;
  };
  std::vector<Row> rows{
      at_most(name + ": device farther out than without the colleague, worst", 1e3 * worst(&VisitCost::outwards_m),
              "mm", 2.0),
      at_most(name + ": force above that without the colleague, worst", worst(&VisitCost::force_N), "N", 0.3),
      at_most(name + ": work on the hand above that without the colleague, until it leaves, worst",
              worst(&VisitCost::work_there_mJ), "mJ", 3.0),
      at_most(name + ": work on the hand beyond the true skin's, from then on, worst",
              worst(&VisitCost::work_returning_mJ), "mJ", 3.0),
      at_most(name + ": work on the hand above that without the colleague, worst", worst(&VisitCost::work_mJ), "mJ",
              3.0),
      at_most(name + ": force step in one tick, worst", *std::max_element(steps_N.begin(), steps_N.end()), "N", 0.1)};
  if (doctor != Doctor::Waits)
    rows.push_back(at_most(name + ": time from the first image without the colleague until the force is 90 % of the "
                                  "force law's, worst",
                           worst(&VisitCost::again_s), "s", 1.0));
  return rows;
}

}  // namespace

std::vector<Study> colleague() {
  std::vector<Study> studies;
  for (const auto& [name, doctor] :
       {std::pair{"colleague/pressed", Doctor::Presses}, std::pair{"colleague/resting", Doctor::Rests},
        std::pair{"colleague/waiting", Doctor::Waits}})
    studies.push_back(
        {name, [name, doctor](const Options& options) { return measure_colleague(name, doctor, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
