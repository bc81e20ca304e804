#pragma once

#include "haptic_station/effects/distance_lattice.h"
#include "support/models/point_model.h"

namespace telepalp::organs {

/// The signed distance to a closed mesh on a lattice of `spacing_m`, `margin_m` beyond the mesh on every side. Exact at
/// each node; which side is inside is told by angle-weighted pseudo-normals (Baerentzen and Aanaes 2005), and a mesh
/// whose faces all look inwards is turned over. `mesh`: in metres, in the frame in which the distance will be asked
/// for. An error when the mesh is not closed, has no volume, or would need more than 16 million nodes.
[[nodiscard]] Result<effects::DistanceLattice> signed_distance(const models::PointModel& mesh, double spacing_m,
                                                               double margin_m);

}  // namespace telepalp::organs
