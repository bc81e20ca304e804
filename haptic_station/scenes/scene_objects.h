#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::scenes {

/// An object inside the body, or a region of the skin, as a solid in the haptic base's frame H.
struct SceneObject {
  std::string name;
  std::shared_ptr<const solids::SolidTree> tree;  // of a layer: shared with its effect
  std::uint32_t effect = 0;                       ///< index of its effect in Scene::effects
};

/// The objects of the scene for pictures, in the order of the effects: layers, cylinders, spheres, organs, prisms, and
/// the stiff regions of the skin as flat discs. Skin and friction cover the whole body and have no object.
[[nodiscard]] std::vector<SceneObject> objects_of(const Scene& scene);

/// A needle in a picture of a scene, as a line [m, in H].
struct SceneNeedle {
  Eigen::Vector3d tip_m;
  Eigen::Vector3d held_m;  ///< its other end
};

/// The needle of the scene's layered tissue, with its tip at the innermost net; nullopt without layers. A needle whose
/// tip is the device point stands upright and is drawn 100 mm long.
[[nodiscard]] std::optional<SceneNeedle> needle_of(const Scene& scene);

}  // namespace telepalp::scenes
