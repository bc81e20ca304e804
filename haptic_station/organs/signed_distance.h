#pragma once

#include "haptic_station/solids/distance_lattice.h"
#include "support/models/point_model.h"

namespace telepalp::organs {

/// The signed distance to a closed mesh, sampled on a lattice with the node spacing `spacing_m` that extends `margin_m`
/// beyond the mesh on every side. The distance is exact at each node. Angle-weighted pseudo-normals (Baerentzen and
/// Aanaes 2005) give its sign; a mesh whose faces all look inwards is turned inside out. `mesh`: in metres, in the
/// frame in which the returned lattice is evaluated. Error: the mesh has no face or no volume, is not closed, has a
/// corner that is not finite, or would need more than 16 million nodes.
[[nodiscard]] Result<solids::DistanceLattice> signed_distance(const models::PointModel& mesh, double spacing_m,
                                                              double margin_m);

}  // namespace telepalp::organs
