#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "tests/hard_cases/surface/driven.h"

// A flat patient under the small camera, by default at 0.8 m with 1 mm of noise at 30 Hz, and a device that moves down
// and stays below the skin during an event of the patient or the image. Time 0 is the first frame.

namespace telepalp::surface {

inline constexpr double kMostStep_N = 0.05;  ///< in a tick, at 500 N/m

struct SeenPatient {
  std::function<double(double)> lift_m = [](double) { return 0.0; };  ///< of the true skin
  std::function<double(double)> tilt = [](double) { return 0.0; };    ///< of depth over x
  /// Depth of an object that hides the skin at a pixel [m]; NaN: none; 0: no measurement.
  std::function<double(int, int, double)> over_m = [](int, int, double) { return std::nan(""); };
  std::function<bool(double)> frame_arrives = [](double) { return true; };
  std::function<bool(double)> accepts = [](double) { return false; };  ///< the doctor accepts an object as skin
  std::function<double(double)> device_x_m = [](double) { return 0.0; };
  std::function<double(double)> raised_m = [](double) { return 0.0; };  ///< of the device over its usual path
  double depth_m = 0.02;                                                ///< of the device below the skin at rest
  double well_again_s = 2.0;  ///< from then on the camera sees the true skin, which no longer moves
  double noise_m = 0.001;
  double frame_s = 1.0 / 30.0;
  std::uint64_t seed = 1;
};

struct Returned {
  bool touched_before = false;
  bool never_lost = true;  ///< between 1.5 s and the end
  bool finite = true;
  double felt_after_s = 1e9;   ///< time from well_again_s until a lasting contact with force
  double off_after_3_s = 1e9;  ///< largest relative error of the displayed depth, 3 to 3.5 s after well_again_s
  double worst_off = 0.0;      ///< largest relative error of the displayed depth from 1.5 s on
  double anchor_off_m = 1e9;   ///< distance of the contact's anchor, moved as displayed, from the true skin at the end
  double most_beyond_N = 0.0;  ///< most force above that of the true skin, from 1.5 s until `well_again_s`
  double last_N = 0.0;         ///< force at `well_again_s`
  bool says_object = false;    ///< at `well_again_s`: the page says that an object lies over the place
  double worst_step_N = 0.0;   ///< while the device is at rest or slides at the path's own speed
};

inline DepthImage image_of(const SeenPatient& patient, double t, std::mt19937_64& random) {
  const Intrinsics camera = small_camera();
  std::normal_distribution<double> noise(0.0, patient.noise_m);
  DepthImage image{.width = camera.width, .height = camera.height, .unit_m = 2e-5, .samples = {}};
  const double z0_m = 0.8 - patient.lift_m(t);
  const double tilt = patient.tilt(t);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const double over_m = patient.over_m(u, v, t);
      const double z_m = std::isnan(over_m) ? z0_m / (1.0 - tilt * (u - camera.cx) / camera.fx) : over_m;
      const double seen_m = z_m > 0.0 ? z_m + noise(random) : 0.0;
      image.samples.push_back(static_cast<std::uint16_t>(std::lround(seen_m / image.unit_m)));
    }
  return image;
}

/// Depth of the device below the true skin, along its normal.
inline double true_depth_m(const SeenPatient& patient, const Vector3d& device, double t) {
  const double tilt = patient.tilt(t);
  return (device.z() - (0.8 - patient.lift_m(t)) - tilt * device.x()) / std::sqrt(1.0 + tilt * tilt);
}

/// The anchor of a contact, as the skin effect follows it.
struct FollowedAnchor {
  Vector3d at = Vector3d::Zero();
  bool known = false;  ///< in contact
  void step(const TouchSample& felt) {
    at = known && felt.in_body ? Vector3d(at + kTick_s * felt.anchor_velocity_m_per_s) : felt.foot.m;
    known = felt.in_body;
  }
};

inline Returned press_on(const SeenPatient& patient) {
  constexpr double kDown_s = 0.5;
  constexpr double kJudgedFrom_s = 1.5;
  constexpr double kPeak_N = 10.0;
  std::mt19937_64 random(patient.seed);
  SurfaceBuilder builder{SurfaceSettings{}};
  Snapshot current;
  Touch touch;
  FollowedAnchor anchor;
  Returned got;
  got.off_after_3_s = 0.0;
  int next_frame = 0;
  double felt_since_s = 1e9;
  Vector3d last_N = Vector3d::Zero();
  const double until_s = patient.well_again_s + 3.5;
  for (int tick = 0; tick * kTick_s < until_s; ++tick) {
    const double t = tick * kTick_s;
    if (t >= next_frame * patient.frame_s) {
      ++next_frame;
      if (patient.accepts(t)) builder.accept_object();
      Snapshot built =
          patient.frame_arrives(t)
              ? builder.add(image_of(patient, t, random), small_camera(), at_s(t),
                            Reach{{Vector3d(patient.device_x_m(t), 0.0, 0.8 - patient.raised_m(t))}, kReach_m})
              : nullptr;
      if (built) touch.adopt(*built, at_s(t));
      if (built) current = std::move(built);
    }
    const double down = std::clamp((t - 0.2) / kDown_s, 0.0, 1.0);
    const Vector3d device(patient.device_x_m(t), 0.0, 0.79 + down * (0.01 + patient.depth_m) - patient.raised_m(t));
    const TouchSample felt = touch.step({device}, at_s(t), kTick_s);
    anchor.step(felt);
    const Vector3d spring_N = kStiffness_N_per_m * (felt.proxy.m - device);
    const Vector3d force_N =
        spring_N * std::min(1.0, kPeak_N / std::max(spring_N.norm(), 1e-9));  // as the limiter does
    got.finite = got.finite && force_N.allFinite();
    if (t > kJudgedFrom_s) got.worst_step_N = std::max(got.worst_step_N, (force_N - last_N).norm());
    last_N = force_N;
    const double deep_m = true_depth_m(patient, device, t);
    const double off = std::abs((felt.proxy.m - device).norm() - std::max(0.0, deep_m)) / std::max(0.001, deep_m);
    const bool pushes = felt.in_body && force_N.norm() > 0.2;
    if (t > kJudgedFrom_s && t < 2.0) got.touched_before = got.touched_before || (pushes && off < 0.1);
    if (t > kJudgedFrom_s) got.never_lost = got.never_lost && felt.in_body;
    const double law_N = std::min(kPeak_N, kStiffness_N_per_m * std::max(0.0, deep_m));
    if (t > kJudgedFrom_s && t < patient.well_again_s) {
      got.most_beyond_N = std::max(got.most_beyond_N, force_N.norm() - law_N);
      got.last_N = force_N.norm();
      got.says_object = builder.object_over_place();
    }
    if (t > kJudgedFrom_s) got.worst_off = std::max(got.worst_off, off);
    if (t >= patient.well_again_s) felt_since_s = pushes ? std::min(felt_since_s, t) : 1e9;
    if (t >= patient.well_again_s + 3.0) got.off_after_3_s = std::max(got.off_after_3_s, off);
  }
  if (anchor.known) got.anchor_off_m = std::abs(true_depth_m(patient, anchor.at, until_s));
  got.felt_after_s = felt_since_s - patient.well_again_s;
  return got;
}

/// A random event of the image or the patient.
inline SeenPatient accident(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  SeenPatient patient;
  patient.seed = seed;
  patient.frame_s = 1.0 / 15.0;
  patient.depth_m = between(0.01, 0.04);
  const double seconds = between(0.0, 5.0);
  const double shift_m = between(std::max(-0.03, 0.006 - patient.depth_m), 0.03);
  const int half_px = static_cast<int>(between(15.0, 45.0));
  const double hand_m = between(0.60, 0.76);
  const auto kind = seed % 5;
  patient.lift_m = [=](double t) { return t < 2.0 ? 0.0 : shift_m; };
  patient.well_again_s = kind == 4 ? 2.0 : 2.0 + seconds;
  const double until_s = patient.well_again_s;
  if (kind == 0) patient.frame_arrives = [=](double t) { return t < 2.0 || t >= until_s; };
  if (kind >= 1 && kind <= 3)
    patient.over_m = [=](int u, int v, double t) {
      if (t < 2.0 || t >= until_s) return std::nan("");
      if (kind == 1) return 0.0;
      if (std::abs(u - 80) > half_px || std::abs(v - 60) > half_px) return std::nan("");
      return kind == 2 ? 0.0 : hand_m;
    };
  return patient;
}

}  // namespace telepalp::surface
