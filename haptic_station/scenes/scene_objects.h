#pragma once

#include <memory>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/solid_tree.h"

namespace telepalp::scenes {

/// An object inside the body, or a region of the skin, as a solid in the haptic base's frame H.
struct SceneObject {
  std::string name;
  std::shared_ptr<const solids::SolidTree> tree;  // shared with the layer's effect
};

/// Everything in the scene that has a place, for pictures: layers, cylinders, spheres, organs, and the regions of the
/// skin as flat discs. Skin and friction are everywhere on the body and not in the list.
[[nodiscard]] std::vector<SceneObject> objects_of(const Scene& scene);

}  // namespace telepalp::scenes
