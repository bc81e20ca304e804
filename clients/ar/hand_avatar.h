#pragma once

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// The doctor's right hand while palpating: fingers together, fingertips down, with the end of a white sleeve. The mesh
/// of the hand is white; avatar_color() gives its colour.
/// Hand frame: origin under the pads of index and middle finger; x points to the little finger, y along the fingers, z
/// away from the body [m].
struct HandAvatar {
  Mesh skin;
  Mesh sleeve;
};
[[nodiscard]] HandAvatar hand_avatar();

/// The hand's colour (linear RGB): skin that turns red with the indentation (paper S1 §II.E, docs/sources.md) and is
/// fully red at 60 mm, the indentation for which S1 states its largest force.
[[nodiscard]] Eigen::Vector3f avatar_color(double indentation_m) noexcept;

}  // namespace telepalp::ar
