#pragma once

#include <vector>

#include "proto/words/rgbd_frame.h"
#include "server/capture/synthetic/shape/mesh.h"

namespace telepalp::capture {

/// Renders the depth [m] of `mesh`, which is in the camera's frame; 0 where a ray misses the mesh. Triangles are curved
/// to match their vertex normals. Source: Boubekeur, Alexa 2008, Phong tessellation, with shape factor 3/4.
[[nodiscard]] std::vector<float> rasterise(const TriangleMesh& mesh, const Intrinsics& camera);

}  // namespace telepalp::capture
