#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/run.h"
#include "tests/bench/hand/studies.h"

// One depth camera cannot tell some things over the patient from skin, and some skin from an object. Here a hand
// presses the patient while such a case happens. The figures have no budget. They give the errors of force and place
// that each case causes, for the table of limits in controller.md.

namespace telepalp::bench::hand {
namespace {

constexpr double kPress_N = 3.0;
constexpr double kEventBegins_s = 6.0;
constexpr double kLimitsUntil_s = 16.0;
constexpr double kOneWay_s = 0.05;

/// The place of a pixel relative to the pressed place, in metres at the skin's depth.
struct Pixel {
  double across_m;  ///< along the image's rows
  double down_m;
};
/// The height of a thing over the patient at a pixel [m], towards the camera; 0: the pixel shows the patient.
using Over = double (*)(const Pixel& pixel, double time_s);

struct Limit {
  const char* name;
  Over over;
  double sits_up_rad;    ///< from kEventBegins_s on
  double frames_lost_s;  ///< from 0.5 s after kEventBegins_s on
};

/// Time since the event [s].
double since(double time_s) noexcept { return time_s - kEventBegins_s; }

/// A thing 12 mm thick and 90 mm wide, laid on the pressed place at once.
double thin_thing(const Pixel& at, double time_s) {
  return since(time_s) >= 0.0 && std::hypot(at.across_m, at.down_m) < 0.045 ? 0.012 : 0.0;
}
/// The patient's forearm, 70 mm thick, 80 mm over the belly: it comes over the place at 0.3 m/s and stays.
double own_arm(const Pixel& at, double time_s) {
  const double middle_m = std::max(0.0, 0.3 - 0.3 * since(time_s));
  return since(time_s) >= 0.0 && std::abs(at.down_m - middle_m) < 0.035 ? 0.08 : 0.0;
}
/// A sheet that hangs 40 mm over the skin is drawn over the place at 20 mm/s. Its front slopes down over 120 mm.
double slow_sheet(const Pixel& at, double time_s) {
  const double behind_m = 0.02 * std::max(0.0, since(time_s)) - (at.across_m + 0.1);
  return since(time_s) < 0.0 ? 0.0 : 0.04 * eased(behind_m / 0.12);
}
/// A cover 180 mm wide, 60 mm over the place.
double cover(const Pixel& at, double time_s) {
  return since(time_s) >= -0.5 && std::hypot(at.across_m, at.down_m) < 0.09 ? 0.06 : 0.0;
}
/// From one image to the next, everything within 160 mm beside the place, most of the image, is 60 mm nearer.
double most_of_the_body(const Pixel& at, double time_s) {
  return since(time_s) >= 0.0 && std::abs(at.across_m) < 0.16 ? 0.06 : 0.0;
}
double nothing(const Pixel&, double) { return 0.0; }

constexpr double kSitUp_rad = 15.0 / 180.0 * std::numbers::pi;
constexpr Limit kLimits[] = {
    {"a thing 12 mm thick on the place", thin_thing, 0.0, 0.0},
    {"the patient's own arm over the place", own_arm, 0.0, 0.0},
    {"a sheet drawn over the place at 20 mm/s", slow_sheet, 0.0, 0.0},
    {"a sit-up of 15 degrees under a cover", cover, kSitUp_rad, 0.0},
    {"a sit-up of 15 degrees while frames are lost for 0.9 s", nothing, kSitUp_rad, 0.9},
    {"more than half of the image covered at once", most_of_the_body, 0.0, 0.0},
};

/// One tick of a run: the device's place, its force and the law's.
struct FeltTick {
  Eigen::Vector3d device_m;
  double pushed_N;
  double law_N;
};

void lay_over(const Limit& limit, const Intrinsics& camera, const Spot& spot, double time_s, DepthImage& depth) {
  const double m_per_px = kCameraAbove_m / camera.fx;
  for (int v = 0; v < depth.height; ++v)
    for (int u = 0; u < depth.width; ++u) {
      std::uint16_t& sample = depth.samples[static_cast<std::size_t>(v * depth.width + u)];
      const double nearer_m =
          limit.over({m_per_px * (u - camera.cx - spot.u), m_per_px * (v - camera.cy - spot.v)}, time_s);
      if (sample > 0) sample = static_cast<std::uint16_t>(std::max(1.0, sample - std::round(nearer_m / depth.unit_m)));
    }
}

/// All ticks of one run, from 0.5 s before the event on. `disturbed`: the thing lies over the patient, or frames are
/// lost; false: the patient moves in the same way, but nothing lies over him and no frame is lost.
std::vector<FeltTick> play_limits_of_sight(const Limit& limit, const Spot& spot, effects::SkinAnchor anchor,
                                           bool disturbed) {
  const auto patient = torso(Sensor::KinectSmooth);
  const Intrinsics camera = patient->settings().camera;
  const auto pose = [&limit](double t) {
    capture::PatientPose now;
    now.breath = capture::breath_at(at_time(t), 0.005, 0.25);
    now.tilt = std::tan(limit.sits_up_rad) * eased(since(t) / 2.25);
    return now;
  };
  Feed feed({.patient = patient,
             .pose = pose,
             .damage =
                 [&](double t, DepthImage& depth) {
                   if (!disturbed) return true;
                   lay_over(limit, camera, spot, t, depth);
                   return since(t) < 0.5 || since(t) >= 0.5 + limit.frames_lost_s;
                 },
             .link = {.one_way_s = kOneWay_s, .loss = 0.0},
             .builder = {}});
  StationSettings settings = with_skin(anchor);
  settings.control.limits.continuous_N = settings.control.limits.peak_N;  // motors that stay cool
  const Eigen::Vector3d normal = normal_at(*patient, spot).v;
  BenchStation station(settings, haptic_from_camera(*patient, spot),
                       std::make_unique<ArmHand>(kArm_N_per_m, [normal](double t) {
                         const double aim_m = kPress_N * (1.0 / kArm_N_per_m + 1.0 / kSkin_N_per_m);
                         const double height_m = 0.04 - (0.04 + aim_m) * eased((t - 0.9) / 1.1);
                         return device::Intention{{height_m * normal}, {}};
                       }));
  std::vector<FeltTick> all;
  run(feed, station, kLimitsUntil_s, [&](const Tick& tick) {
    if (since(tick.time_s) >= -0.5) all.push_back({tick.device_m, tick.pushed_N(), tick.law_N()});
  });
  return all;
}

struct Cost {
  double beyond_N = 0.0;    ///< most force above the law's on the true skin
  double missing_N = 0.0;   ///< most force below it
  double outwards_m = 0.0;  ///< most by which the device is farther out than without the thing
  double inwards_m = 0.0;   ///< most by which it is deeper
};

Cost cost_of(const std::vector<FeltTick>& with, const std::vector<FeltTick>& without, const Eigen::Vector3d& normal) {
  Cost cost;
  for (std::size_t i = 0; i < with.size(); ++i) {
    // The error that the run has without the thing too, such as a lag behind a sit-up, is not counted.
    const double usual_N = without[i].pushed_N - without[i].law_N;
    const double off_N = with[i].pushed_N - with[i].law_N;
    const double out_m = normal.dot(with[i].device_m - without[i].device_m);
    cost.beyond_N = std::max(cost.beyond_N, off_N - std::max(0.0, usual_N));
    cost.missing_N = std::max(cost.missing_N, std::min(0.0, usual_N) - off_N);
    cost.outwards_m = std::max(cost.outwards_m, out_m);
    cost.inwards_m = std::max(cost.inwards_m, -out_m);
  }
  return cost;
}

std::vector<Row> measure_limits_of_sight(const Limit& limit, const Options& options) {
  const auto places = spots();
  std::vector<Cost> all(2 * places.size());
  for_each_parallel(static_cast<int>(all.size()), options, [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    const Spot& spot = places[at / 2];
    const auto anchor = at % 2 == 0 ? effects::SkinAnchor::FollowsSurface : effects::SkinAnchor::Sliding;
    all[at] = cost_of(play_limits_of_sight(limit, spot, anchor, true), play_limits_of_sight(limit, spot, anchor, false),
                      normal_at(*torso(Sensor::KinectSmooth), spot).v);
  });
  const auto most = [&](double Cost::*value) {
    double worst = 0.0;
    for (const Cost& one : all) worst = std::max(worst, one.*value);
    return worst;
  };
  const std::string name = std::string("limit/") + limit.name + ": ";
  return {measured(name + "force above the force law's on the true skin, most", most(&Cost::beyond_N), "N"),
          measured(name + "force below it, most", most(&Cost::missing_N), "N"),
          measured(name + "device farther out than without it, most", 1e3 * most(&Cost::outwards_m), "mm"),
          measured(name + "device deeper than without it, most", 1e3 * most(&Cost::inwards_m), "mm")};
}

}  // namespace

std::vector<Study> limits_of_sight() {
  std::vector<Study> studies;
  for (const Limit& limit : kLimits)
    studies.push_back({std::string("limit/") + limit.name,
                       [&limit](const Options& options) { return measure_limits_of_sight(limit, options); }});
  return studies;
}

}  // namespace telepalp::bench::hand
