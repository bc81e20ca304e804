#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "haptic_station/organs/signed_distance.h"

namespace telepalp::organs {

struct OrganShapeSettings {
  double unit_m = 1.0;                                                  ///< metres for one unit of the file
  Eigen::Isometry3d haptic_from_model = Eigen::Isometry3d::Identity();  ///< applied after the scaling by `unit_m`
  double cell_m = 0.004;   ///< node spacing; docs/accuracy.md has the error that it causes
  double margin_m = 0.02;  ///< the lattice extends so far beyond the organ on each side
};

/// Reads a closed mesh (.ply, .obj) and samples the signed distance to it in the haptic base's frame H. The call takes
/// a fraction of a second, so it is made while loading and never on the haptic thread. A file over 64 MiB is refused
/// before it is read. Each error names the file and a fix.
[[nodiscard]] Result<std::shared_ptr<const solids::DistanceLattice>> read_organ_shape(
    const std::filesystem::path& file, const OrganShapeSettings& settings);

}  // namespace telepalp::organs
