#include "server/capture/synthetic/synthetic_patient.h"

#include <cmath>
#include <utility>

#include "server/capture/synthetic/appearance.h"

namespace telepalp::server {
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
      return Error{.what = std::string(one.name) + " is " + std::to_string(one.value),
                   .where = where,
                   .fix = "give " + std::to_string(one.least) + " to " + std::to_string(one.most)};
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
      sensor_(*rest_, settings),
      picture_(paint(*rest_, settings.seed)) {}

Breath SyntheticPatient::breath(SessionTime time) const noexcept {
  return breath_at(time, settings_.amplitude_m, settings_.rate_hz);
}

RgbdFrame SyntheticPatient::frame_at(SessionTime time, std::uint64_t sequence) const {
  RgbdFrame frame;
  frame.captured = time;
  frame.sequence = sequence;
  frame.camera = {.depth = settings_.camera, .color = settings_.camera, .color_registered = true};
  frame.depth = {.width = settings_.camera.width,
                 .height = settings_.camera.height,
                 .unit_m = settings_.depth_unit_m,
                 .samples = {}};
  sensor_.measure(breath(time).lift_m, to_nanoseconds(time), frame.depth.samples);
  frame.color = picture_;
  if (settings_.noise != DepthNoise::None) add_color_noise(frame.color.rgb, to_nanoseconds(time), settings_.seed);
  return frame;
}

TrueSurface SyntheticPatient::true_surface(SessionTime time) const noexcept { return {rest_, breath(time)}; }

}  // namespace telepalp::server
