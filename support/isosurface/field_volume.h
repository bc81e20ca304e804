#pragma once

#include "support/isosurface/isosurface.h"

namespace telepalp::isosurface {

/// A volume with its standard error.
struct Volume {
  double m3 = 0.0;
  double error_m3 = 0.0;
};

/// The volume of the inside of a field in `box`, from the field alone: boxes that lie wholly inside or outside count
/// exactly, and the boxes at the surface by random points (stratified Monte Carlo, always the same points).
[[nodiscard]] Volume volume_of(const Field& field, const Eigen::AlignedBox3d& box);

}  // namespace telepalp::isosurface
