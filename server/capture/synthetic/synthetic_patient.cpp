#include "server/capture/synthetic/synthetic_patient.h"

#include <cmath>
#include <utility>

#include "proto/words/error_line.h"
#include "server/capture/synthetic/appearance.h"

namespace telepalp::capture {
namespace {

struct Bounds {
  const char* name;
  double value;
  double least;
  double most;
};

Result<void> check(const SyntheticSettings& settings, const std::string& where) {
  if (!is_well_formed(settings.camera))
    return Error{.what = "has a camera without a size or a focal length",
                 .where = where,
                 .fix = "give width, height up to " + std::to_string(kMaxImageSide) + " and fx, fy in pixels"};
  const Bounds all[] = {{"camera_above_body_m", settings.camera_above_body_m, 0.2, 4.0},
                        {"amplitude_m", settings.amplitude_m, 0.0, 0.05},
                        {"rate_hz", settings.rate_hz, 0.0, 2.0},
                        {"gaussian_sigma_m", settings.gaussian_sigma_m, 0.0, 0.1},
                        {"depth_unit_m", settings.depth_unit_m, 0.00005, 0.01}};
  for (const Bounds& one : all)
    if (!(one.value >= one.least && one.value <= one.most))
      return Error{.what = std::string(one.name) + " is " + number_text(one.value),
                   .where = where,
                   .fix = "give " + number_text(one.least) + " to " + number_text(one.most)};
  return {};
}

}  // namespace

Result<SyntheticPatient> SyntheticPatient::make(const TriangleMesh& mesh, const SyntheticSettings& settings,
                                                const std::string& where) {
  if (const Result<void> checked = check(settings, where); !checked) return checked.error();
  Result<RestShape> rest = lay_under_camera(mesh, settings.camera, settings.camera_above_body_m, where);
  if (!rest) return rest.error();
  return SyntheticPatient{settings, std::move(*rest)};
}

SyntheticPatient::SyntheticPatient(const SyntheticSettings& settings, RestShape rest)
    : settings_(settings),
      rest_(std::make_shared<const RestShape>(std::move(rest))),
      sensor_(rest_, settings),
      motion_(settings.motion, settings.amplitude_m, settings.rate_hz, settings.seed),
      picture_(paint(*rest_, settings.seed)) {}

RgbdFrame SyntheticPatient::frame_of(const PatientPose& pose, SessionTime time, std::uint64_t sequence) const {
  RgbdFrame frame;
  frame.captured = time;
  frame.sequence = sequence;
  frame.camera = {.depth = settings_.camera, .color = settings_.camera, .color_registered = true};
  frame.depth = depth_of(pose, time);
  frame.color = picture_;
  if (pose.colleague) paint_glove(*pose.colleague, settings_.camera, frame.color);
  if (settings_.noise != DepthNoise::None) add_color_noise(frame.color.rgb, to_nanoseconds(time), settings_.seed);
  return frame;
}

DepthImage SyntheticPatient::depth_of(const PatientPose& pose, SessionTime time) const {
  DepthImage depth{.width = settings_.camera.width,
                   .height = settings_.camera.height,
                   .unit_m = settings_.depth_unit_m,
                   .samples = {}};
  sensor_.measure(pose, to_nanoseconds(time), depth.samples);
  return depth;
}

RgbdFrame SyntheticPatient::frame_at(SessionTime time, std::uint64_t sequence) const {
  return frame_of(pose(time), time, sequence);
}

/// The visits begin 8 s into each slot of 24 s. Every second one lies on the skin; the others hover 60 mm over it.
PatientPose SyntheticPatient::pose(SessionTime time) const {
  PatientPose pose = motion_.at(time);
  if (!settings_.colleague) return pose;
  constexpr double kSlot_s = 24.0;
  const double now_s = 1e-9 * static_cast<double>(to_nanoseconds(time));
  const double slot = std::floor(now_s / kSlot_s);
  const bool lies = std::fmod(slot, 2.0) != 0.0;
  const Intrinsics& camera = settings_.camera;
  const ColleagueVisit visit{.place = surface_of({}).at_pixel(camera.cx, camera.cy).at,
                             .over_m = lies ? 0.0 : 0.06,
                             .heading_rad = -1.2,
                             .begins_s = 8.0};
  pose.colleague = visit.at(now_s - kSlot_s * slot, surface_of({}), surface_of(pose));
  return pose;
}

TrueSurface SyntheticPatient::surface_of(const PatientPose& pose) const noexcept { return {rest_, pose}; }

TrueSurface SyntheticPatient::true_surface(SessionTime time) const { return {rest_, pose(time)}; }

}  // namespace telepalp::capture
