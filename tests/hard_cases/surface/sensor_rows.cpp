#include <cmath>

#include "support/sensor/depth_sensor.h"
#include "tests/hard_cases/surface/driven.h"

namespace telepalp::surface {
namespace {

constexpr int kFrames = 60;

/// A still belly, 0.15 m high, on a bed at 0.85 m.
double belly_m(double u, double v) {
  const double x = (u - 80.0) / 40.0;
  const double y = (v - 60.0) / 40.0;
  return 0.85 - 0.15 * std::exp(-0.5 * (x * x + y * y));
}

/// Changes an image of the sensor on its way; the number of the frame.
using Software = std::function<void(int, DepthImage&)>;
void nothing(int, DepthImage&) {}

/// The last of kFrames snapshots of the belly through one builder.
Snapshot seen_by(const sensor::DepthSensorSettings& settings, bool disparity_levels, const Software& software) {
  SurfaceSettings surface;
  surface.disparity_levels = disparity_levels;
  SurfaceBuilder builder(surface);
  const sensor::DepthSensor sensor(settings);
  Snapshot last;
  for (int frame = 0; frame < kFrames; ++frame) {
    const sensor::Exposure exposure = sensor.expose(frame);
    const Intrinsics camera = small_camera();
    DepthImage image{.width = camera.width, .height = camera.height, .unit_m = settings.unit_m, .samples = {}};
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u)
        image.samples.push_back(
            exposure.sample(static_cast<float>(belly_m(u, v)), static_cast<std::uint32_t>(image.samples.size())));
    software(frame, image);
    last = builder.add(image, camera, at_s(1.0 + frame / 30.0), std::nullopt);
  }
  return last;
}

/// RMS distance of the true skin from the displayed surface around the belly's top.
double error_m(const Snapshot& snapshot) {
  double sum = 0.0;
  int count = 0;
  for (int v = 40; v <= 80; v += 4)
    for (int u = 60; u <= 100; u += 4) {
      const Intrinsics camera = small_camera();
      const double z = belly_m(u, v);
      const Vector3d skin((u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z);
      const FieldSample at = snapshot->evaluate(skin, Vector3d::Zero(), MotionBasis{});
      sum += at.valid ? at.f_m * at.f_m : 1.0;
      ++count;
    }
  return std::sqrt(sum / count);
}

constexpr sensor::DepthSensorSettings kKinect{};
constexpr sensor::DepthSensorSettings kWithoutSteps{.disparity_steps = false};

AssertionResult steps_in_whole_mm() {
  return all_of({below_m("the levels are known", error_m(seen_by(kKinect, true, nothing)), 4.5e-5),
                 above("as rounded", error_m(seen_by(kKinect, false, nothing)), 5.5e-5, 1e6, "um")});
}

AssertionResult whole_mm_without_steps() {
  const double as_rounded_m = error_m(seen_by(kWithoutSteps, false, nothing));
  const double with_levels_m = error_m(seen_by(kWithoutSteps, true, nothing));
  return all_of({{with_levels_m == as_rounded_m, "nothing is changed"}, below_m("error", with_levels_m, 6e-5)});
}

/// Software puts another object into the image, between the sensor's levels, from the first frame or from the 20th on.
template <int kFrom>
AssertionResult pasted_object() {
  const Software paste = [](int frame, DepthImage& image) {
    for (int v = 0; v < 40 && frame >= kFrom; ++v)
      for (int u = 0; u < 24; ++u) {
        std::uint16_t& sample = image.samples[static_cast<std::size_t>(v * image.width + u)];
        sample = static_cast<std::uint16_t>(sample - 81);
      }
  };
  return all_of({below_m("skin beside it", error_m(seen_by(kKinect, true, paste)), 6e-5)});
}

/// The server changes from one camera to another with the same unit and image.
AssertionResult another_camera() {
  const sensor::DepthSensor smooth(kWithoutSteps);
  const Software replaced = [&](int frame, DepthImage& image) {
    if (frame < 20) return;
    const sensor::Exposure exposure = smooth.expose(frame);
    for (int v = 0; v < image.height; ++v)
      for (int u = 0; u < image.width; ++u) {
        const auto at = static_cast<std::size_t>(v * image.width + u);
        image.samples[at] = exposure.sample(static_cast<float>(belly_m(u, v)), static_cast<std::uint32_t>(at));
      }
  };
  return all_of({below_m("error after a second", error_m(seen_by(kKinect, true, replaced)), 8e-5)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> sensor_rows() {
  using namespace surface;
  return {
      {"disparity steps in whole mm", "rounding moves each level, always alike", "the levels' own depths",
       steps_in_whole_mm},
      {"whole mm without steps", "there are no levels to find", "left as it is", whole_mm_without_steps},
      {"object pasted into the image", "its samples are no levels", "the skin keeps its levels", pasted_object<0>},
      {"object pasted in later", "its samples are no levels", "the skin keeps its levels", pasted_object<20>},
      {"another camera, no steps", "the levels known are not its own", "they are dropped", another_camera},
  };
}

}  // namespace telepalp::hard_cases
