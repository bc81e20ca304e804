#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "haptic_station/organs/signed_distance.h"

namespace telepalp::organs {

struct OrganShapeSettings {
  double unit_m = 1.0;                                                  ///< metres for one unit of the file
  Eigen::Isometry3d haptic_from_model = Eigen::Isometry3d::Identity();  ///< after `unit_m`
  double cell_m = 0.004;                                                ///< of the lattice; docs/accuracy.md
  double margin_m = 0.02;                                               ///< beyond the organ, known all around
};

/// Reads a closed mesh (.ply, .obj) and samples the distance to it, in H. Takes a fraction of a second: at load, never
/// on the control thread. Every error names the file and what to do.
[[nodiscard]] Result<std::shared_ptr<const effects::DistanceLattice>> read_organ_shape(
    const std::filesystem::path& file, const OrganShapeSettings& settings);

}  // namespace telepalp::organs
