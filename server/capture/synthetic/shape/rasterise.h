#pragma once

#include <vector>

#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/shape/mesh.h"

namespace telepalp::server {

/// The nearest depth [m] that each pixel's ray meets on `mesh`, given in the camera's frame; 0 where it meets nothing.
/// Between its corners a triangle bulges as its vertex normals ask. Source: Boubekeur, Alexa 2008, Phong tessellation,
/// with their shape factor 3/4.
[[nodiscard]] std::vector<float> rasterise(const TriangleMesh& mesh, const Intrinsics& camera);

}  // namespace telepalp::server
