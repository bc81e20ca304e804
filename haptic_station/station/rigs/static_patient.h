#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::station {

/// A point of a patient's skin, in H.
struct SkinPoint {
  Eigen::Vector3d at_m;
  Eigen::Vector3d outwards;  ///< unit
};

/// A patient from a model file, touched without camera or server.
struct StaticPatient {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  /// Its type says DepthCamera, because the model's frame takes the place of the camera's.
  Transform<HapticBase, DepthCamera> haptic_from_model;
  std::string remarks;
  std::vector<SkinPoint> skin;  ///< the model's samples, in H
};

/// Reads and places the model of `scene`. `folder`: base of the model's relative path. With scene.center_on_surface,
/// H's origin becomes the highest skin point within 15 mm of the vertical through the skin's median x and z. `anyway`:
/// accept a model with too coarse samples, too much noise or contradicting normals.
[[nodiscard]] Result<StaticPatient> open_static_patient(const scenes::Scene& scene, const std::filesystem::path& folder,
                                                        bool anyway);

/// Applies the value of `--surface` to the scene: "model:FILE[,unit_m=M][,samples=N]" sets the static model, any other
/// word the surface setting, "" nothing. Error: an unknown option or a bad number after FILE.
[[nodiscard]] Result<void> ask_for_surface(const std::string& word, scenes::Scene& scene);

}  // namespace telepalp::station
