#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::station {

/// A patient that is a model in a file: touched as it is, without camera or server.
struct StaticPatient {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  /// The model's own frame stands where a camera's would.
  Transform<HapticBase, DepthCamera> haptic_from_model;
  std::string remarks;
};

/// Reads and places the model that `scene` names. `folder`: its file is relative to it. With center_on_surface the
/// highest skin above the model's middle becomes H's origin.
[[nodiscard]] Result<StaticPatient> open_static_patient(const scenes::Scene& scene,
                                                        const std::filesystem::path& folder);

/// What `--surface` asks for: "model:FILE[,unit_m=M][,samples=N]" becomes the scene's static model, any other word its
/// surface setting.
[[nodiscard]] Result<void> ask_for_surface(const std::string& word, scenes::Scene& scene);

}  // namespace telepalp::station
