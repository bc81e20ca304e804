#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/touch/touch.h"
#include "tests/haptic_station/periods.h"
#include "tests/haptic_station/surface/analytic_surface.h"

namespace telepalp::surface {
namespace {

using Eigen::Vector3d;

constexpr double kZ_m = 0.8;
constexpr double kSigma_m = 0.001;
constexpr double kUnit_m = 1e-4;

Intrinsics small_camera() { return {.width = 320, .height = 240, .fx = 290.0, .fy = 290.0, .cx = 159.5, .cy = 119.5}; }

/// A bed on which a belly of the image's size rises by `lift_m(t)` at its middle, with 1 mm of noise.
class Patient {
 public:
  explicit Patient(std::function<double(double)> lift_m) : lift_m_(std::move(lift_m)) {}

  [[nodiscard]] double depth_at(double u, double v, double t) const {
    const double x = (u - 159.5) / 90.0, y = (v - 119.5) / 90.0;
    return kZ_m - lift_m_(t) * std::exp(-0.5 * (x * x + y * y));
  }
  [[nodiscard]] double middle_at(double t) const { return depth_at(159.5, 119.5, t); }

  [[nodiscard]] DepthImage seen_at(double t) {
    const Intrinsics camera = small_camera();
    DepthImage image{.width = camera.width, .height = camera.height, .unit_m = kUnit_m, .samples = {}};
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u)
        image.samples.push_back(
            static_cast<std::uint16_t>(std::lround((depth_at(u, v, t) + kSigma_m * any_(random_)) / kUnit_m)));
    return image;
  }

 private:
  std::function<double(double)> lift_m_;
  std::mt19937_64 random_{5};
  std::normal_distribution<double> any_;
};

double breath(double t) { return 0.005 * std::pow(std::sin(std::numbers::pi * 0.25 * t), 4.0); }

SessionTime at_s(double t) { return session_time(0) + from_seconds(t + 1.0); }

struct Seen {
  double at_s = 0.0;
  std::shared_ptr<const SurfaceSnapshot> snapshot;
};

std::vector<Seen> watch(Patient& patient, double until_s, double keep_from_s, const SurfaceSettings& settings = {}) {
  SurfaceBuilder builder{settings};
  const Reach reach{{Vector3d(0, 0, kZ_m)}, 0.03};
  std::vector<Seen> seen;
  for (int n = 0; n * kFrame_s < until_s; ++n) {
    auto snapshot = builder.add(patient.seen_at(n * kFrame_s), small_camera(), at_s(n * kFrame_s), reach);
    if (n * kFrame_s >= keep_from_s) seen.push_back({n * kFrame_s, std::move(snapshot)});
  }
  return seen;
}

/// Signed distance of the predicted surface's middle from the true skin; positive outside.
double error_m(const Seen& seen, const Patient& patient, double age_s) {
  const Vector3d truth(0.0, 0.0, patient.middle_at(seen.at_s + age_s));
  return -seen.snapshot->evaluate(truth, Vector3d::Zero(), motion_basis(seen.snapshot->motion, age_s)).f_m;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double rms_error_m(const std::vector<Seen>& seen, const Patient& patient, double age_s, double from_s, double to_s) {
  std::vector<double> errors;
  for (const Seen& one : seen)
    if (one.at_s >= from_s && one.at_s < to_s) errors.push_back(error_m(one, patient, age_s));
  return rms(errors);
}

TEST(Prediction, AKnownBreathIsCarriedForwardThroughAnyDelayOfALink) {
  Patient patient(breath);
  const std::vector<Seen> seen = watch(patient, 16.0, 12.0);
  for (const double age_s : {0.0, 0.05, 0.1, 0.2})
    EXPECT_LT(rms_error_m(seen, patient, age_s, 12.0, 16.0), 4e-5) << "age " << age_s << " s";
}

TEST(Prediction, BeforeTheBreathIsKnownVelocityCarriesTheSurface) {
  Patient patient(breath);
  const std::vector<Seen> seen = watch(patient, 3.6, 0.8);
  std::vector<double> still;
  for (const Seen& one : seen) still.push_back(patient.middle_at(one.at_s) - patient.middle_at(one.at_s + 0.1));
  EXPECT_LT(rms_error_m(seen, patient, 0.1, 0.8, 3.6), 0.5 * rms(still)) << "half of what not moving it would err";
}

/// No breath is like the one before, so that the breathing model never holds.
TEST(Prediction, AnIrregularBreathIsCarriedForwardByTheMotionThatAllCellsShare) {
  const auto irregular = [](double t) {
    const double phase = 2.0 * std::numbers::pi * (0.25 * t + 0.25 * std::sin(0.7 * t));
    return 0.0025 * (1.0 + 0.3 * std::sin(1.1 * t)) * (1.0 - std::cos(phase));
  };
  const auto error_m = [&](bool shared) {
    Patient patient(irregular);
    SurfaceSettings settings;
    settings.shared = shared;
    return rms_error_m(watch(patient, 14.0, 6.0, settings), patient, 0.1, 6.0, 14.0);
  };
  EXPECT_LT(error_m(true), 0.6 * error_m(false));
}

TEST(Prediction, AHeldBreathEndsTheBreathingModelWithinASecond) {
  static constexpr double kHeldFrom_s = 13.3;  // during the rise of the breath, where the model's confidence is highest
  Patient patient([](double t) { return breath(std::min(t, kHeldFrom_s)); });
  const std::vector<Seen> seen = watch(patient, 16.0, 13.0);
  EXPECT_LT(rms_error_m(seen, patient, 0.1, 13.0, 13.2), 5e-5);
  EXPECT_LT(rms_error_m(seen, patient, 0.1, kHeldFrom_s, 14.3), 6e-4) << "never as wrong as the breath is deep";
  EXPECT_LT(rms_error_m(seen, patient, 0.1, 14.3, 16.0), 1e-4);
}

/// Nearly all errors at 200 ms lie within three stated standard deviations, as for a Gaussian.
TEST(Prediction, TheStatedUncertaintyCoversTheError) {
  Patient patient(breath);
  int within = 0;
  int all = 0;
  for (const Seen& one : watch(patient, 16.0, 0.5))
    for (const double age_s : {0.0, 0.1, 0.2}) {
      Touch touch;
      touch.adopt(*one.snapshot, one.snapshot->captured);
      const Vector3d outside(0.0, 0.0, patient.middle_at(one.at_s + age_s) - 0.002);
      const TouchSample sample = touch.step({outside}, one.snapshot->captured + from_seconds(age_s), 0.0005);
      ASSERT_TRUE(sample.valid);
      ++all;
      if (std::abs(error_m(one, patient, age_s)) < 3.0 * sample.uncertainty_m) ++within;
    }
  EXPECT_GT(within, 0.95 * all) << within << " of " << all;
}

TEST(Prediction, UncertaintyGrowsWithAge) {
  Patient patient(breath);
  const std::vector<Seen> seen = watch(patient, 3.0, 2.9);
  Touch touch;
  touch.adopt(*seen.front().snapshot, seen.front().snapshot->captured);
  double last_m = 0.0;
  for (double age_s = 0.0; age_s < 0.5; age_s += 0.1) {
    const TouchSample sample =
        touch.step({Vector3d(0, 0, kZ_m - 0.02)}, seen.front().snapshot->captured + from_seconds(age_s), 0.0005);
    EXPECT_GT(sample.uncertainty_m, last_m) << "age " << age_s;
    last_m = sample.uncertainty_m;
  }
}

TEST(Prediction, APredictionWithoutNewFramesSlowsDownAndStops) {
  Patient patient(breath);
  const Seen seen = watch(patient, 13.0, 12.95).front();
  const double stops_s = 2.0 * seen.snapshot->motion.freeze_from_s;
  const auto place_m = [&](double age_s) {
    return seen.snapshot->evaluate(Vector3d(0, 0, kZ_m), Vector3d::Zero(), motion_basis(seen.snapshot->motion, age_s))
        .f_m;
  };
  double last_m = place_m(0.0);
  for (double age_s = 0.0; age_s < 3.0; age_s += 0.0005) {
    const double now_m = place_m(age_s);
    EXPECT_LT(std::abs(now_m - last_m), 1e-5) << "20 mm/s, at age " << age_s;
    last_m = now_m;
  }
  EXPECT_DOUBLE_EQ(place_m(stops_s), place_m(stops_s + 1.0));
}

TEST(Prediction, ASurfaceSeenThisInstantAlreadyMoves) {
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = 1.5;
  EXPECT_FLOAT_EQ(motion_basis(model, 0.0).rate[2], 1.5F);
  EXPECT_FLOAT_EQ(motion_basis(model, 0.0).rate[0], 1.0F);
  for (const float value : motion_basis(model, 0.0).value) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace telepalp::surface
