#pragma once

#include <filesystem>
#include <vector>

#include "haptic_station/station/bill/seen_body.h"
#include "haptic_station/station/rigs/scene_parts.h"

namespace telepalp::station {

/// Error of an effect's force while hand and patient move, over the ticks in which the effect gives force.
struct MovingError {
  std::size_t ticks = 0;
  bool compared = true;  ///< false: a slow stage computes the effect, and this comparison runs none
  double p50_N = 0.0;
  double p99_N = 0.0;
  double stiffness_N_per_m = 0.0;  ///< of the effect; p50_N and p99_N over it are errors of the felt depth [m]
};

/// The error of each effect of `scene`, in its order, over `seconds` of the scene's trial. The station's own loop feels
/// the surface that it builds from noisy images, 40 ms late, and places the objects as it sees the skin move. Each
/// effect's force is compared with the force of the same effect at the true skin of `body` at the same instant: with
/// the object at its true place, with the proxy of solids found by 60 rounds to within 0.1 nm, and with meshes sampled
/// twice as densely. Limiter and relaxed springs are left out. With a static model (`parts`), the model is the true
/// skin. `file`: the scene's file, for the meshes. Error: a mesh that cannot be sampled so densely.
[[nodiscard]] Result<std::vector<MovingError>> errors_in_motion(const scenes::Scene& scene, const SceneParts& parts,
                                                                const std::filesystem::path& file, const SeenBody& body,
                                                                double seconds);

}  // namespace telepalp::station
