#pragma once

#include <Eigen/Core>

namespace telepalp::mixed {

/// A matt paint: a mean colour, varied softly over lengths of `scale_m`; `printed` adds lines of print of 3 mm.
struct Paint {
  Eigen::Vector3d color;  ///< sRGB, 0 to 255
  double scale_m = 0.05;
  bool printed = false;
  double contrast = 1.0;  ///< strength of the soft variation
};

/// The colour of a painted point under light from above left. `at`: in the world's frame [m].
[[nodiscard]] Eigen::Vector3d painted(const Paint& paint, const Eigen::Vector3d& at, const Eigen::Vector3d& normal);

}  // namespace telepalp::mixed
