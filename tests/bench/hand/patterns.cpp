#include "tests/bench/hand/patterns.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "server/capture/synthetic/motion/patient_motion.h"
#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {
namespace {

using capture::Motion;
using capture::PatientPose;

constexpr double kBreath_m = 0.005, kRate_hz = 0.25;

double bump(double since_s, double lasts_s) noexcept {
  if (since_s <= 0.0 || since_s >= lasts_s) return 0.0;
  const double wave = std::sin(std::numbers::pi * since_s / lasts_s);
  return wave * wave;
}

PatientPose with_lift(double lift_m) noexcept { return {.breath = {.lift_m = lift_m}}; }

double regular_m(double t, double amplitude_m) noexcept {
  return capture::breath_at(at_time(t), amplitude_m, kRate_hz).lift_m;
}

/// The synthetic patient's own motion.
template <Motion kMotion>
PatientPose moved(double t) {
  static const capture::PatientMotion motion(kMotion, kBreath_m, kRate_hz, 3);
  return motion.at(at_time(300.0 + t));
}

/// From 0.2 to 0.5 Hz within 20 s and back.
double changing_m(double t) noexcept {
  constexpr double kSlow_hz = 0.2, kFast_hz = 0.5, kTurn_s = 20.0;
  const double mean_hz = 0.5 * (kSlow_hz + kFast_hz), half_hz = 0.5 * (kFast_hz - kSlow_hz);
  const double w = std::numbers::pi / kTurn_s;  // the rate is mean - half cos(w t)
  const double breaths = mean_hz * t - half_hz / w * std::sin(w * t);
  return kBreath_m * std::pow(std::sin(std::numbers::pi * breaths), 4.0);
}

/// Syllables of 3 to 8 mm at 1 to 3 Hz.
double talk_m(double t) noexcept {
  double begins_s = 0.0;
  for (std::uint64_t i = 0;; ++i) {
    const double lasts_s = 1.0 / device::Random(2 * i + 7).uniform(1.0, 3.0);
    if (t < begins_s + lasts_s) return device::Random(2 * i + 8).uniform(0.003, 0.008) * bump(t - begins_s, lasts_s);
    begins_s += lasts_s;
  }
}

/// The body 10 mm higher for 3 s, every 6 s.
double shifted_m(double t) noexcept {
  const double in_slot_s = std::fmod(t, 6.0);
  const auto ramp = [](double since_s) { return std::clamp(since_s / 0.05, 0.0, 1.0); };
  return 0.01 * (ramp(in_slot_s - 1.0) - ramp(in_slot_s - 4.0));
}

/// 15 degrees within 2.25 s, every 20 s; then 6 s upright.
double sat_up(double t) noexcept {
  const double in_slot_s = std::fmod(t, 20.0);
  return std::tan(15.0 / 180.0 * std::numbers::pi) *
         (eased((in_slot_s - 3.0) / 2.25) - eased((in_slot_s - 11.0) / 2.25));
}

constexpr double kAtOnce_s = 0.0;
const Pattern kBreaths[] = {{"regular", [](double t) { return with_lift(regular_m(t, kBreath_m)); }, kAtOnce_s},
                            {"irregular", moved<Motion::Irregular>, kAtOnce_s},
                            {"10 mm", [](double t) { return with_lift(regular_m(t, 2.0 * kBreath_m)); }, kAtOnce_s},
                            {"hold", moved<Motion::Hold>, kAtOnce_s},
                            {"drift", moved<Motion::Drift>, kAtOnce_s},
                            {"rate 0.2 to 0.5 Hz", [](double t) { return with_lift(changing_m(t)); }, kAtOnce_s}};
const Pattern kSitUp{"sit-up",
                     [](double t) {
                       PatientPose pose = with_lift(regular_m(t, kBreath_m));
                       pose.tilt = sat_up(t);
                       return pose;
                     },
                     kAtOnce_s};
const Pattern kTalk{"talk", [](double t) { return with_lift(talk_m(t)); }, kAtOnce_s};
const Pattern kJolts[] = {
    {"cough", moved<Motion::Cough>, kAtOnce_s},
    {"cough of 8 mm in 0.3 s",
     [](double t) { return with_lift(regular_m(t, kBreath_m) + 0.008 * bump(std::fmod(t, 4.7) - 1.0, 0.3)); },
     kAtOnce_s},
    {"shift of 10 mm in 50 ms",
     [](double t) {
       PatientPose pose = with_lift(regular_m(t, kBreath_m));
       pose.rise_m = shifted_m(t);
       return pose;
     },
     0.2}};

}  // namespace

std::span<const Pattern> breaths() noexcept { return kBreaths; }
const Pattern& sit_up() noexcept { return kSitUp; }
const Pattern& talk() noexcept { return kTalk; }
std::span<const Pattern> jolts() noexcept { return kJolts; }

const Pattern& pattern(std::string_view name) {
  for (const auto& group :
       {breaths(), jolts(), std::span<const Pattern>(&kSitUp, 1), std::span<const Pattern>(&kTalk, 1)})
    for (const Pattern& one : group)
      if (one.name == name) return one;
  std::abort();
}

double ridden_m(const Pattern& pattern, const PoseScript& pose, const capture::SyntheticPatient& patient,
                const Transform<HapticBase, DepthCamera>& haptic_from_camera, double time_s) {
  return rest_height_m(patient, pose(std::max(0.0, time_s - pattern.rides_after_s)), haptic_from_camera);
}

PoseScript script(const Pattern& pattern, std::shared_ptr<const capture::SyntheticPatient> patient, const Spot& spot) {
  const auto placed = haptic_from_camera(*patient, spot);
  const Transform<DepthCamera, HapticBase> camera_from_haptic = placed.inverse();
  const auto height = patient->surface_of(with_lift(kBreath_m))
                          .height_along(camera_from_haptic * Point<HapticBase>{},
                                        camera_from_haptic * Vector<HapticBase>{Eigen::Vector3d::UnitY()});
  const double per_lift = height ? height->m / kBreath_m : 1.0;
  return [pose = pattern.pose, per_lift](double t) {
    PatientPose at = pose(t);
    at.breath.lift_m /= per_lift;
    at.breath.speed_m_per_s /= per_lift;
    return at;
  };
}

}  // namespace telepalp::bench::hand
