#include <algorithm>
#include <numbers>
#include <random>

#include "tests/haptic_station/periods.h"
#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

constexpr double kDelay_s = 0.1;
constexpr double kNoise_m = 0.001;

/// The height of a flat patient over time [m].
using Lift = std::function<double(double)>;

/// Breaths of 2.5 to 5.8 s, 4 s on average, and of 5 mm ± 30 % [m].
double irregular_breath_m(double t) {
  const double phase = 2.0 * std::numbers::pi * (0.25 * t + 0.25 * std::sin(0.7 * t));
  return 0.0025 * (1.0 + 0.3 * std::sin(1.1 * t)) * (1.0 - std::cos(phase));
}

/// Two coughs a second on a slow breath, 5 mm each, over within 0.3 s.
double coughs_m(double t) {
  const double since_s = std::fmod(t, 0.5);
  return 0.001 * (1.0 - std::cos(1.2 * t)) +
         (t < 8.0 ? 0.0 : 0.005 * std::exp(-std::pow((since_s - 0.15) / 0.05, 2.0)));
}

struct Window {
  double from_s;
  double until_s;
};

/// RMS distance between the surface predicted to now and the true skin, over images of a camera that is kDelay_s away.
double rms_off_m(const Lift& lift, const SurfaceSettings& settings, const Window& judged) {
  const Intrinsics camera = small_camera();
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  SurfaceBuilder builder{settings};
  double square = 0.0;
  int count = 0;
  for (double t = 0.0; t < judged.until_s; t += kFrame_s) {
    DepthImage image{.width = camera.width, .height = camera.height, .unit_m = 2e-5, .samples = {}};
    for (int i = 0; i < camera.width * camera.height; ++i)
      image.samples.push_back(static_cast<std::uint16_t>(std::lround((0.8 - lift(t) + noise(random)) / image.unit_m)));
    const Snapshot snapshot = builder.add(image, camera, at_s(1.0 + t), Reach{{Vector3d(0, 0, 0.8)}, 0.03});
    if (t < judged.from_s) continue;
    const Vector3d skin(0.0, 0.0, 0.8 - lift(t + kDelay_s));
    const FieldSample seen = snapshot->evaluate(skin, Vector3d::Zero(), motion_basis(snapshot->motion, kDelay_s));
    square += seen.valid ? seen.f_m * seen.f_m : 1.0;  // a place without a surface is a failure
    ++count;
  }
  return std::sqrt(square / count);
}

/// The error of the shipped prediction, relative to the better of holding the last surface and of each place's
/// velocity.
double to_the_better(const Lift& lift, const Window& judged) {
  SurfaceSettings hold;
  hold.predict = hold.breathing = hold.shared = false;
  SurfaceSettings velocity;
  velocity.breathing = velocity.shared = false;
  return rms_off_m(lift, SurfaceSettings{}, judged) /
         std::min(rms_off_m(lift, hold, judged), rms_off_m(lift, velocity, judged));
}

AssertionResult breathes_irregularly() {
  return all_of({below("error to the better of both", to_the_better(irregular_breath_m, {6.0, 14.0}), 1.05, 1.0, "")});
}

AssertionResult holds_the_breath() {
  const Lift held = [](double t) { return irregular_breath_m(std::min(t, 9.3)); };
  return all_of({below("error to the better of both, as it stops", to_the_better(held, {8.8, 11.0}), 1.05, 1.0, "")});
}

/// A shift by 10 mm within 0.6 s, every three seconds and up and down in turn, on a slow breath.
double shifts_m(double t) {
  const double into = std::min(1.0, std::fmod(t, 3.0) / 0.6);
  const double risen = into * into * (3.0 - 2.0 * into);
  const bool up = static_cast<int>(t / 3.0) % 2 == 0;
  return 0.001 * (1.0 - std::cos(1.2 * t)) + (t < 6.0 ? 0.0 : 0.01 * (up ? risen : 1.0 - risen));
}

AssertionResult shifts() {
  return all_of({below("error to the better of both", to_the_better(shifts_m, {6.0, 18.0}), 1.05, 1.0, "")});
}

/// A patient who rises by 10 mm within 0.2 s.
double rise_m(double t) {
  const double into = std::clamp((t - 8.0) / 0.2, 0.0, 1.0);
  return 0.01 * into * into * (3.0 - 2.0 * into);
}

/// How far the skin that is displayed 0.5 s after an image lies beyond the end of the rise [m]; the worst of all
/// images.
double overshoot_m() {
  const Intrinsics camera = small_camera();
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  SurfaceBuilder builder{SurfaceSettings{}};
  double worst_m = 0.0;
  for (double t = 0.0; t < 8.5; t += kFrame_s) {
    DepthImage image{.width = camera.width, .height = camera.height, .unit_m = 2e-5, .samples = {}};
    for (int i = 0; i < camera.width * camera.height; ++i)
      image.samples.push_back(
          static_cast<std::uint16_t>(std::lround((0.8 - rise_m(t) + noise(random)) / image.unit_m)));
    const Snapshot snapshot = builder.add(image, camera, at_s(1.0 + t), Reach{{Vector3d(0, 0, 0.8)}, 0.03});
    const Vector3d risen(0.0, 0.0, 0.8 - rise_m(9.0));
    const FieldSample seen = snapshot->evaluate(risen, Vector3d::Zero(), motion_basis(snapshot->motion, 0.5));
    worst_m = std::max(worst_m, seen.valid ? -seen.f_m : 1.0);  // a place without a surface is a failure
  }
  return worst_m;
}

AssertionResult rises_before_a_gap() {
  return all_of({below("the skin goes beyond the rise by", overshoot_m(), 0.01, 1e3, "mm")});
}

AssertionResult coughs() {
  return all_of({below("error to the better of both", to_the_better(coughs_m, {8.0, 14.0}), 1.05, 1.0, "")});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> prediction_rows() {
  using namespace surface;
  return {
      {"patient breathes irregularly", "no breath is like the one before", "never worse than holding or velocity",
       breathes_irregularly},
      {"patient holds the breath", "a known breath ends at once", "never worse than holding or velocity",
       holds_the_breath},
      {"patient coughs", "jerks that end as suddenly as they begin", "never worse than holding or velocity", coughs},
      {"patient shifts", "a motion that ends while its prediction goes on", "never worse than holding or velocity",
       shifts},
      {"half a second without images as the patient rises", "no image shows that the rise has ended",
       "the skin goes at most as far beyond the rise as it rose", rises_before_a_gap}};
}

}  // namespace telepalp::hard_cases
