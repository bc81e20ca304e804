#pragma once

#include <cstddef>

#include "support/models/point_model.h"

namespace telepalp::surface {

/// What was found and mended when a mesh's faces were made to agree.
struct Winding {
  std::size_t open_edges = 0;  ///< of one face alone
  std::size_t turned = 0;      ///< faces that looked the other way than their neighbours
};

/// Turns triangles so that those that share an edge look the same way. A piece in which any was turned, and that has no
/// open edge, then looks outwards; any other piece keeps the way in which most of its faces looked. Vertices in one
/// place count as one, since exporters double them along seams.
Winding make_faces_agree(models::PointModel& mesh);

}  // namespace telepalp::surface
