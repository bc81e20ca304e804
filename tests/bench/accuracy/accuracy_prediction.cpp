#include "tests/bench/accuracy/accuracy_prediction.h"

#include <cmath>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/tracking/hand_estimate.h"
#include "haptic_station/tracking/hand_trace.h"
#include "tests/bench/accuracy/accuracy_rms.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/fixed_kalman.h"
#include "tests/haptic_station/surface/touch_scenario.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using surface::SurfaceSettings;
using testing::scene_time;

constexpr Eigen::Index kHeight = 1;  // the tracker's y

/// Predicts the hand at a sample's time by every model, from the samples up to `newest`.
class HandModels {
 public:
  void update(const tracking::TraceSample& sample) {
    velocity_.update(sample.at, sample.palm.m);
    damped_.update(sample.at, sample.palm.m);
    (void)adaptive_.update(sample.at, {sample.palm.m});
  }

  [[nodiscard]] std::array<Vector3d, 5> at(SessionTime when, const tracking::TraceSample& newest,
                                           const tracking::TraceSample& before) const {
    const double share = to_seconds(when - newest.at) / to_seconds(newest.at - before.at);
    return {newest.palm.m, newest.palm.m + share * (newest.palm.m - before.palm.m), velocity_.predict(when),
            damped_.predict(when), adaptive_.predict(when).at.m};
  }

 private:
  FixedKalman velocity_{kFixedVelocity};
  FixedKalman damped_{kFixedDamped};
  tracking::HandEstimate adaptive_;
};

HandPredictionError predict(const tracking::HandTrace& trace, const std::string& name, std::size_t ahead) {
  constexpr double kTrackerLostHand_s = 0.03;
  constexpr std::size_t kWarmUp = 5;
  HandPredictionError error{.trace = name};
  HandModels models;
  Distribution ahead_ms;
  for (std::size_t i = 0; i + ahead < trace.samples.size(); ++i) {
    models.update(trace.samples[i]);
    if (i < kWarmUp) continue;
    const tracking::TraceSample& truth = trace.samples[i + ahead];
    const double ahead_s = to_seconds(truth.at - trace.samples[i].at);
    const double last_s = to_seconds(trace.samples[i].at - trace.samples[i - 1].at);
    if (ahead_s > kTrackerLostHand_s * static_cast<double>(ahead) || !(last_s > 0.0) || last_s > kTrackerLostHand_s)
      continue;
    ahead_ms.add(1e3 * ahead_s);
    const auto said = models.at(truth.at, trace.samples[i], trace.samples[i - 1]);
    for (std::size_t model = 0; model < said.size(); ++model) {
      const Vector3d off = said[model] - truth.palm.m;
      error.all_m[model] += off.squaredNorm();
      error.height_m[model] += off[kHeight] * off[kHeight];
    }
  }
  error.predictions = ahead_ms.count();
  error.ahead_ms = ahead_ms.p50();
  for (double& sum : error.all_m) sum = std::sqrt(sum / static_cast<double>(error.predictions));
  for (double& sum : error.height_m) sum = std::sqrt(sum / static_cast<double>(error.predictions));
  return error;
}

struct TimeVariant {
  std::string model;
  std::string what;
  SurfaceSettings settings;
};

std::vector<TimeVariant> time_variants() {
  const auto with = [](bool temporal, double memory, bool predict, bool breathing) {
    SurfaceSettings settings;
    settings.temporal = temporal;
    settings.memory_frames = memory;
    settings.predict = predict;
    settings.breathing = breathing;
    return settings;
  };
  const double usual = SurfaceSettings{}.memory_frames;
  std::vector<TimeVariant> variants{
      {"none", "each frame alone", with(false, usual, false, false)},
      {"hold", "average, without prediction", with(true, usual, false, false)},
      {"velocity", "average, carried by its normal velocity", with(true, usual, true, false)},
      {"breathing (default)",
       "average over at most " + std::to_string(static_cast<int>(usual)) +
           " frames, carried by its normal velocity and by the breathing model",
       with(true, usual, true, true)}};
  for (const int frames : {10, 30, 60, 120, 240})
    if (frames != static_cast<int>(usual))
      variants.push_back({"breathing, memory " + std::to_string(frames),
                          "average over at most " + std::to_string(frames) + " frames",
                          with(true, frames, true, true)});
  return variants;
}

/// Adds f at points of the true surface: 25 points around the spot, at one instant.
void add_error(const surface::SurfaceSnapshot& snapshot, const capture::TrueSurface& truth, const testing::Spot& spot,
               double age_s, RootMeanSquare& error_m) {
  const surface::MotionBasis basis = surface::motion_basis(snapshot.motion, age_s);
  for (const double x : {-0.02, -0.01, 0.0, 0.01, 0.02})
    for (const double y : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
      const auto there = truth.on_ray_through({spot.at + Vector3d(x, y, 0.0)});
      const surface::FieldSample seen = snapshot.evaluate(there.at.m, there.normal.v, basis);
      if (there.on_body && seen.valid) error_m.add(seen.f_m);
    }
}

using Stream = std::vector<surface::SurfaceBuilder>;

Stream builders(const std::vector<TimeVariant>& variants) {
  Stream all;
  for (const TimeVariant& variant : variants) all.emplace_back(variant.settings);
  return all;
}

/// Three seconds of a still patient, then a step of 3 mm towards the camera.
Result<void> watch_still(const std::vector<TimeVariant>& variants, std::vector<SurfacePredictionError>& errors) {
  const auto patient = testing::torso({.sigma_m = 0.001});
  if (!patient) return patient.error();
  const testing::Spot spot = testing::belly(*patient);
  const surface::Reach reach{{spot.at}, surface::kReach_m};
  constexpr int kStill = 90;
  constexpr int kAfter = 90;
  constexpr double kStep_m = 0.003;
  const auto step_samples = static_cast<int>(std::lround(kStep_m / patient->settings().depth_unit_m));
  Stream stream = builders(variants);
  std::vector<Distribution> build_ms(variants.size());
  for (SurfacePredictionError& error : errors) error.step_frames = kAfter;
  for (int n = 0; n < kStill + kAfter; ++n) {
    RgbdFrame frame = patient->frame_at(scene_time(n * kFrame_s), static_cast<std::uint64_t>(n));
    if (n >= kStill)
      for (std::uint16_t& sample : frame.depth.samples)
        if (sample > step_samples) sample = static_cast<std::uint16_t>(sample - step_samples);
    for (std::size_t k = 0; k < variants.size(); ++k) {
      const double start_us = thread_us();
      const auto snapshot = stream[k].add(frame.depth, frame.camera.depth, frame.captured, reach);
      build_ms[k].add(1e-3 * (thread_us() - start_us));
      if (n == 29 || n == kStill - 1) {
        RootMeanSquare error_m;
        add_error(*snapshot, patient->true_surface(frame.captured), spot, 0.0, error_m);
        (n == 29 ? errors[k].still_1s_m : errors[k].still_3s_m) = error_m.value();
      }
      if (n < kStill || errors[k].step_frames < kAfter) continue;
      const Vector3d moved = spot.at * ((spot.at.z() - kStep_m) / spot.at.z());
      const double f_m = snapshot->evaluate(moved, spot.normal, {}).f_m;
      if (std::abs(f_m) < 0.0005) errors[k].step_frames = n - kStill + 1;
    }
  }
  for (std::size_t k = 0; k < variants.size(); ++k) errors[k].build_ms = build_ms[k].p50();
  return {};
}

/// Twelve seconds of breathing. The error is measured from the eighth second on, when the breathing model has locked
/// on.
Result<void> watch_breathing(const std::vector<TimeVariant>& variants, std::vector<SurfacePredictionError>& errors) {
  const auto patient = testing::torso({.sigma_m = 0.001, .amplitude_m = 0.005});
  if (!patient) return patient.error();
  const testing::Spot spot = testing::belly(*patient);
  const surface::Reach reach{{spot.at}, surface::kReach_m};
  Stream stream = builders(variants);
  std::vector<std::array<RootMeanSquare, kSurfaceAges_s.size()>> error_m(variants.size());
  for (int n = 0; n < 360; ++n) {
    const RgbdFrame frame = patient->frame_at(scene_time(n * kFrame_s), static_cast<std::uint64_t>(n));
    for (std::size_t k = 0; k < variants.size(); ++k) {
      if (!variants[k].settings.temporal && n < 240) continue;
      const auto snapshot = stream[k].add(frame.depth, frame.camera.depth, frame.captured, reach);
      if (n < 240) continue;
      for (std::size_t age = 0; age < kSurfaceAges_s.size(); ++age)
        add_error(*snapshot, patient->true_surface(frame.captured + from_seconds(kSurfaceAges_s[age])), spot,
                  kSurfaceAges_s[age], error_m[k][age]);
    }
  }
  for (std::size_t k = 0; k < variants.size(); ++k)
    for (std::size_t age = 0; age < kSurfaceAges_s.size(); ++age) errors[k].breathing_m[age] = error_m[k][age].value();
  return {};
}

}  // namespace

Result<std::vector<HandPredictionError>> hand_predictions() {
  std::vector<HandPredictionError> errors;
  for (const std::string name : {"confidence-demo", "grab", "pinch", "test-paddle-rightwards"}) {
    const auto trace = tracking::read_hand_trace(TELEPALP_SOURCE_DIR "/tests/data/hand_tracking/" + name + ".csv");
    if (!trace) return trace.error();
    for (const std::size_t ahead : {1U, 2U, 4U}) errors.push_back(predict(*trace, name, ahead));
  }
  return errors;
}

Result<std::array<double, 5>> hand_model_us() {
  const auto trace = tracking::read_hand_trace(TELEPALP_SOURCE_DIR "/tests/data/hand_tracking/grab.csv");
  if (!trace) return trace.error();
  FixedKalman velocity{kFixedVelocity};
  FixedKalman damped{kFixedDamped};
  tracking::HandEstimate adaptive;
  double moved = 0.0;  // used below, so that no prediction is left out by the compiler
  const auto each_us = [&](const auto& work) {
    const double start_us = thread_us();
    for (const tracking::TraceSample& sample : trace->samples) moved += work(sample);
    return (thread_us() - start_us) / static_cast<double>(trace->samples.size());
  };
  const double velocity_us = each_us([&](const tracking::TraceSample& sample) {
    velocity.update(sample.at, sample.palm.m);
    return velocity.predict(sample.at).x();
  });
  const double damped_us = each_us([&](const tracking::TraceSample& sample) {
    damped.update(sample.at, sample.palm.m);
    return damped.predict(sample.at).x();
  });
  const double adaptive_us = each_us([&](const tracking::TraceSample& sample) {
    (void)adaptive.update(sample.at, {sample.palm.m});
    return adaptive.predict(sample.at).at.m.x();
  });
  if (!std::isfinite(moved))
    return Error{.what = "a prediction is not finite", .where = "grab.csv", .fix = "check the recorded hand"};
  return std::array{0.0, 0.0, velocity_us, damped_us, adaptive_us};
}

Result<std::vector<SurfacePredictionError>> surface_predictions() {
  const std::vector<TimeVariant> variants = time_variants();
  std::vector<SurfacePredictionError> errors;
  for (const TimeVariant& variant : variants) errors.push_back({.model = variant.model, .what = variant.what});
  if (const auto done = watch_still(variants, errors); !done) return done.error();
  if (const auto done = watch_breathing(variants, errors); !done) return done.error();
  return errors;
}

}  // namespace telepalp::bench
