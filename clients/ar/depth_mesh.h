#pragma once

#include "clients/ar/mesh.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// The coloured surface that a depth camera sees, as S1 §II.E draws it. Depth is smoothed for the eye only. No triangle
/// spans a jump in depth, and lone pixels at silhouettes are left out. Without colour it is the grey of a mannequin.
/// `frame` must be well formed. Normals point to the camera.
[[nodiscard]] Mesh depth_mesh(const RgbdFrame& frame);

}  // namespace telepalp::ar
