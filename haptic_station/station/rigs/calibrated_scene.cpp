#include "haptic_station/station/rigs/calibrated_scene.h"

#include "haptic_station/calibration/calibration_file.h"

namespace telepalp::station {

Result<scenes::Scene> calibrated(scenes::Scene scene, const std::filesystem::path& file) {
  const Result<msg::Calibration> measured = calibration::read_calibration(file);
  if (!measured) return measured.error();
  if (!measured->has_haptic_from_tracker() && !measured->has_haptic_from_camera())
    return Error{.what = "holds no calibration: neither haptic_from_tracker nor haptic_from_camera",
                 .where = file.string(),
                 .fix = "measure a transform with telepalp-station calibrate, or leave --calibration out"};
  if (measured->has_haptic_from_tracker()) {
    const auto transform = calibration::transform_of(measured->haptic_from_tracker(), file.string());
    if (!transform) return transform.error();
    scene.haptic_from_tracker.iso = *transform;
  }
  if (measured->has_haptic_from_camera()) {
    const auto transform = calibration::transform_of(measured->haptic_from_camera(), file.string());
    if (!transform) return transform.error();
    scene.haptic_from_camera.iso = *transform;
    scene.center_on_surface = false;
  }
  return scene;
}

}  // namespace telepalp::station
