#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "haptic_station/effects/effect_bank.h"
#include "messages/inside.pb.h"
#include "proto/words/frames.h"

namespace telepalp::core {

/// A layer inside the body, and the number of its effect in the scene.
struct InnerLayer {
  std::shared_ptr<const effects::SolidLayer> solid;  ///< shared with the layer's effect
  std::uint32_t effect = 0;
};

/// What viewers draw of a scene's layers.
struct InnerSurfaces {
  msg::InnerStructures drawn;
  std::vector<std::string> left_out;  ///< layers that are not drawn: "layer liver: the solid has no bounds …"
};

/// The surfaces of the layers by dual contouring, thinned to one point in each cell of a grid; each point is then moved
/// onto the layer's surface. A layer's cells grow until it has at most its equal share of 36 000 points. A layer
/// without bounds or surface, or with too many points after six attempts, is left out. Takes up to some seconds.
/// nullopt: `stop` was requested; `stop` is checked at each cell and each point.
[[nodiscard]] std::optional<InnerSurfaces> inner_structures(std::span<const InnerLayer> layers,
                                                            const std::stop_token& stop = {});

/// Sets the pose of H in the depth camera's frame: the points of `inside` are in H.
void set_place(msg::InnerStructures& inside, const Transform<HapticBase, DepthCamera>& haptic_from_camera);

}  // namespace telepalp::core
