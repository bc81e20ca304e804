#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/force_step.h"
#include "tests/bench/hand/studies.h"

// A hand is held in the skin of a patient who moves. Measures the difference between the force and the true skin's
// force over the delay, also for builders that hold the last surface or predict it only by its velocity.

namespace telepalp::bench::hand {
namespace {

constexpr std::array kReach_N{0.09, 0.10, 0.14};
constexpr double kRegularReach_N = 0.065;

/// Errors by delay; the larger one of both anchors.
struct Errors {
  OfDelays rmse_N{};
  double step_N = 0.0;
  double law_step_N = 0.0;  ///< largest change of the law's force on the true skin in one tick of contact
  std::vector<std::vector<float>> off_N{};  ///< the error over time, by anchor and then by delay
};

/// RMS error of an oracle that uses the one of two predictions that is better at each instant [N]; the larger one of
/// both anchors. A predictor that chooses between the two at each instant, by whatever it knows, cannot err less than
/// this.
double oracle_N(const Errors& one, const Errors& other, std::size_t delay) {
  double worst_N = 0.0;
  for (std::size_t at = delay; at < one.off_N.size(); at += kDelays_s.size()) {
    double square = 0.0;
    for (std::size_t i = 0; i < one.off_N[at].size(); ++i) {
      const double off_N = std::min(std::abs(one.off_N[at][i]), std::abs(other.off_N[at][i]));
      square += off_N * off_N;
    }
    worst_N = std::max(worst_N, std::sqrt(square / static_cast<double>(one.off_N[at].size())));
  }
  return worst_N;
}

surface::SurfaceSettings builder(bool predict, bool breathing) {
  surface::SurfaceSettings settings;
  settings.predict = predict;
  settings.breathing = breathing;
  settings.shared = breathing;  // the two others know no more than each place's own velocity
  return settings;
}

struct Scene {
  std::shared_ptr<const capture::SyntheticPatient> patient;
  PoseScript pose;
  Spot spot;
  Link link = link_before_delays();
  bool delayed = true;  ///< false: no delay beyond the link's
};

Errors play_force_error(const Scene& scene, const surface::SurfaceSettings& builder_settings) {
  Feed feed({.patient = scene.patient, .pose = scene.pose, .link = scene.link, .builder = builder_settings});
  const auto placed = haptic_from_camera(*scene.patient, scene.spot);
  const auto path = [&](double t, const control::ControlOutput&) {
    return Point<HapticBase>{
        {0.0, reaching_m(t, kDepth_m) + rest_height_m(*scene.patient, scene.pose(t), placed), 0.0}};
  };
  struct Judged {
    BenchStation station;
    std::size_t delay;
    double square = 0.0;
    ForceSteps steps{};
    double law_N = 0.0;
    double law_step_N = 0.0;
    std::vector<float> off_N{};
  };
  std::vector<Judged> all;
  for (const auto anchor : {effects::SkinAnchor::FollowsSurface, effects::SkinAnchor::Sliding})
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
      StationSettings settings = with_skin(anchor);
      settings.extra_delay_s = scene.delayed ? kDelays_s[delay] - kJitter_s : 0.0;
      all.push_back({BenchStation(settings, placed, std::make_unique<RigidHand>(path)), delay});
    }
  const auto ticks = static_cast<std::int64_t>(kUntil_s / kTick_s);
  std::int64_t judged = 0;
  for (std::int64_t i = 0; i < ticks; ++i) {
    const double t = static_cast<double>(i) * kTick_s;
    const auto snapshot = feed.step(t, all.front().station.device_camera());
    const capture::TrueSurface truth = feed.truth(t);
    const bool counts = t >= kFrom_s;
    judged += counts ? 1 : 0;
    for (Judged& one : all) {
      one.station.receive(snapshot, t);
      const Tick tick = one.station.step(t, truth);
      if (!counts) continue;
      one.steps.add(tick);
      const double law_before_N = std::exchange(one.law_N, tick.law_N());
      if (law_before_N > 0.0 && one.law_N > 0.0)
        one.law_step_N = std::max(one.law_step_N, std::abs(one.law_N - law_before_N));
      const double off_N = tick.pushed_N() - tick.law_N();  // without contact, the error is the whole force of the law
      one.square += off_N * off_N;
      one.off_N.push_back(static_cast<float>(off_N));
    }
  }
  Errors errors;
  for (Judged& one : all) {
    errors.off_N.push_back(std::move(one.off_N));
    double& worst = errors.rmse_N[one.delay];
    worst = std::max(worst, std::sqrt(one.square / static_cast<double>(judged)));
    errors.step_N = std::max(errors.step_N, one.steps.worst_N());
    errors.law_step_N = std::max(errors.law_step_N, one.law_step_N);
  }
  return errors;
}

Scene scene_of(capture::Motion motion, std::size_t spot) {
  const auto patient = torso(Sensor::Kinect, motion);
  const double begins_s = 300.0 + 97.0 * static_cast<double>(spot);
  return {.patient = patient,
          .pose = [patient, begins_s](double t) { return patient->pose(at_time(begins_s + t)); },
          .spot = spots()[spot]};
}

std::vector<Row> measure_force_error(const std::string& name, capture::Motion motion, const Options& options) {
  constexpr int kBuilders = 3;  // the default, hold-last, velocity-only
  const auto spot_count = static_cast<int>(spots().size());
  std::vector<Errors> all(static_cast<std::size_t>(kBuilders * spot_count));
  for_each_parallel(kBuilders * spot_count, options, [&](int i) {
    const surface::SurfaceSettings settings[kBuilders] = {builder(true, true), builder(false, false),
                                                          builder(true, false)};
    all[static_cast<std::size_t>(i)] =
        play_force_error(scene_of(motion, static_cast<std::size_t>(i % spot_count)), settings[i / spot_count]);
  });
  double worst_ratio = 0.0;
  double oracle_ratio = 0.0;
  double step_N = 0.0;
  double law_step_N = 0.0;
  Errors worst;
  for (std::size_t spot = 0; spot < spots().size(); ++spot)
    for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
      const Errors& shipped = all[spot];
      const double better =
          std::min(all[spot + spots().size()].rmse_N[delay], all[spot + 2 * spots().size()].rmse_N[delay]);
      worst_ratio = std::max(worst_ratio, shipped.rmse_N[delay] / better);
      const double oracle = oracle_N(all[spot + spots().size()], all[spot + 2 * spots().size()], delay);
      oracle_ratio = std::max(oracle_ratio, oracle / better);
      worst.rmse_N[delay] = std::max(worst.rmse_N[delay], shipped.rmse_N[delay]);
      step_N = std::max(step_N, shipped.step_N);
      law_step_N = std::max(law_step_N, shipped.law_step_N);
    }
  const bool asked = motion == capture::Motion::Irregular || motion == capture::Motion::Hold ||
                     motion == capture::Motion::Drift || motion == capture::Motion::Regular;
  std::vector<Row> rows;
  for (std::size_t delay = 0; delay < kDelays_s.size(); ++delay) {
    const std::string row = name + ": force RMSE at a delay of " + delay_name(delay) + ", worst";
    const double reach_N = motion == capture::Motion::Regular ? kRegularReach_N : kReach_N[delay];
    rows.push_back(asked ? at_most(row, worst.rmse_N[delay], "N", reach_N) : measured(row, worst.rmse_N[delay], "N"));
  }
  rows.push_back(
      at_most(name + ": force RMSE, divided by that of the better simple prediction (hold last, velocity only), worst",
              worst_ratio, "", 1.05));
  rows.push_back(measured(name + ": force RMSE of an ideal choice between hold last and velocity only at each instant, "
                                 "divided by that of the better, worst",
                          oracle_ratio, ""));
  const bool breathes_only =
      motion != capture::Motion::Shift && motion != capture::Motion::SitUp && motion != capture::Motion::Cough;
  rows.push_back(at_most(name + ": force step in one tick, worst", step_N, "N", breathes_only ? 0.05 : 0.1));
  rows.push_back(measured(name + ": force step in one tick of the force law on the true skin, worst", law_step_N, "N"));
  return rows;
}

/// The error that no predictor can remove: the sensor's error on a still patient without delay.
std::vector<Row> measure_floor(const Options& options) {
  const auto still = [](double) { return capture::PatientPose{}; };
  const Link no_link{.one_way_s = 0.0, .jitter_s = 0.0, .loss = 0.0, .seed = 5};
  const auto regular = [](Sensor sensor) {
    const auto patient = torso(sensor);
    return [patient](double t) { return patient->pose(at_time(t)); };
  };
  const auto worst = [&](const std::function<Scene(std::size_t)>& scene) {
    std::array<double, 3> rmse_N{};
    for_each_parallel(3, options, [&](int i) {
      const Errors errors = play_force_error(scene(static_cast<std::size_t>(i)), {});
      rmse_N[static_cast<std::size_t>(i)] = *std::max_element(errors.rmse_N.begin(), errors.rmse_N.end());
    });
    return *std::max_element(rmse_N.begin(), rmse_N.end());
  };
  return {measured("floor: force RMSE, still patient, no delay, error of the sensor alone", worst([&](std::size_t i) {
                     return Scene{torso(), still, spots()[i], no_link, false};
                   }),
                   "N"),
          measured("floor: force RMSE, regular breathing, no delay", worst([&](std::size_t i) {
                     return Scene{torso(), regular(Sensor::Kinect), spots()[i], no_link, false};
                   }),
                   "N"),
          measured("floor: force RMSE, regular breathing, delay to 200 ms, sensor without disparity steps",
                   worst([&](std::size_t i) {
                     return Scene{torso(Sensor::KinectSmooth), regular(Sensor::KinectSmooth), spots()[i]};
                   }),
                   "N")};
}

}  // namespace

std::vector<Study> force_error() {
  std::vector<Study> studies;
  for (const capture::Motion motion : capture::all_motions()) {
    const std::string name = "rmse/" + std::string(capture::name(motion));
    studies.push_back(
        {name, [name, motion](const Options& options) { return measure_force_error(name, motion, options); }});
  }
  studies.push_back({"floor", measure_floor});
  return studies;
}

}  // namespace telepalp::bench::hand
