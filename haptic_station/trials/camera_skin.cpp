#include <cmath>
#include <numbers>

#include "haptic_station/core/surface_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/trials/trial_skin.h"
#include "support/sensor/depth_sensor.h"

namespace telepalp::trials {
namespace {

constexpr double kAlongRadius_m = 0.6;  // radius of curvature in the direction from head to feet
constexpr double kAcrossRadius_m = 0.25;

constexpr Intrinsics kCamera{320, 240, 525.0, 525.0, 159.5, 119.5};

/// A barrel-shaped skin under a simulated depth camera.
class CameraSkin final : public TrialSkin {
 public:
  explicit CameraSkin(const BellySettings& belly)
      : belly_(belly),
        stage_({}, [](const DepthImage&, const Intrinsics&) { return trial_camera(); }, {}),
        sensor_({.seed = belly.seed}) {}

  [[nodiscard]] const loop::TouchableSurface* newer(double time_s, const Point<HapticBase>& device) override {
    if (time_s * kFrame_hz + 1e-9 < static_cast<double>(frames_)) return nullptr;
    ++frames_;
    const SessionTime now{from_seconds(time_s)};
    stage_.arrived(core::seen_image(seen_at(time_s, now), kCamera, now, frames_, now));
    const auto result = core::run_at_once(stage_, now, device);
    if (!result->surface) return nullptr;
    before_ = std::move(shown_.snapshot);
    shown_ = *result->surface;
    return &shown_;
  }

  [[nodiscard]] double true_depth_m(const Point<HapticBase>& point, double time_s) const override {
    const double x_slope = point.m.x() / kAlongRadius_m;
    const double z_slope = point.m.z() / kAcrossRadius_m;
    const double above_m = point.m.y() - height_m(point.m.x(), point.m.z(), time_s);
    return -above_m / std::sqrt(1.0 + x_slope * x_slope + z_slope * z_slope);
  }

 private:
  [[nodiscard]] double height_m(double x_m, double z_m, double time_s) const noexcept {
    const double breath_m =
        belly_.breathing_m * std::sin(2.0 * std::numbers::pi * belly_.rate_hz * (belly_.begins_s + time_s));
    return breath_m - 0.5 * x_m * x_m / kAlongRadius_m - 0.5 * z_m * z_m / kAcrossRadius_m;
  }

  [[nodiscard]] DepthImage seen_at(double time_s, SessionTime now) const {
    DepthImage depth{
        .width = kCamera.width, .height = kCamera.height, .unit_m = sensor_.settings().unit_m, .samples = {}};
    const sensor::Exposure exposure = sensor_.expose(to_nanoseconds(now));
    const double camera_m = trial_camera().iso.translation().y();
    std::uint32_t pixel = 0;
    for (int v = 0; v < kCamera.height; ++v)
      for (int u = 0; u < kCamera.width; ++u) {
        const double x = (u - kCamera.cx) / kCamera.fx;
        const double y = (v - kCamera.cy) / kCamera.fy;
        double z_m = camera_m;
        for (int step = 0; step < 4; ++step) z_m = camera_m - height_m(x * z_m, y * z_m, time_s);
        depth.samples.push_back(exposure.sample(static_cast<float>(z_m), pixel++));
      }
    return depth;
  }

  BellySettings belly_;
  core::SurfaceStage stage_;
  sensor::DepthSensor sensor_;
  loop::TouchableSurface shown_;
  std::shared_ptr<const surface::SurfaceSnapshot> before_;  // shared: the loop refers to it until it gets `shown_`
  std::uint64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<TrialSkin> camera_skin(const BellySettings& belly) { return std::make_unique<CameraSkin>(belly); }

}  // namespace telepalp::trials
