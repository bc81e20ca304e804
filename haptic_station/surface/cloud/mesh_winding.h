#pragma once

#include <cstddef>

#include "support/models/point_model.h"

namespace telepalp::surface {

/// Result of make_faces_agree().
struct Winding {
  std::size_t open_edges = 0;  ///< edges that belong to one face only
  std::size_t turned = 0;      ///< faces reversed because they contradicted most of their piece
};

/// Reverses triangles until neighbours have equal orientation. A connected piece that was changed and has no open edge
/// is then oriented outwards; any other piece keeps the orientation of most of its faces. Vertices at equal positions
/// count as one, because exporters duplicate vertices along seams.
Winding make_faces_agree(models::PointModel& mesh);

}  // namespace telepalp::surface
