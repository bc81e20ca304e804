#pragma once

#include "clients/ar/mesh.h"

namespace telepalp::ar {

/// The doctor's right hand as it palpates: fingers together, pads down, with the end of a white sleeve. White paint on
/// the hand's part; see avatar_color.
/// Hand frame: origin under the pads of index and middle finger; x to the little finger, y along the fingers, z away
/// from the body [m].
struct HandAvatar {
  Mesh skin;
  Mesh sleeve;
};
[[nodiscard]] HandAvatar hand_avatar();

/// The hand's colour: skin that turns red the deeper the end-effector is inside (S1 §II.E), fully so at 60 mm, the
/// depth that S1 quotes its largest force for.
[[nodiscard]] Eigen::Vector3f avatar_color(double indentation_m) noexcept;

}  // namespace telepalp::ar
