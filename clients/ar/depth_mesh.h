#pragma once

#include "clients/ar/mesh.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// Makes the coloured surface of an RGB-D frame, as in paper S1 §II.E (docs/sources.md). Depth is smoothed for display
/// only. No triangle spans a depth break, and isolated pixels at silhouettes are left out. Without colour the surface
/// is grey. `frame` must be well formed. Normals point to the camera.
[[nodiscard]] Mesh depth_mesh(const RgbdFrame& frame);

}  // namespace telepalp::ar
