#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/neighbor_index.h"
#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {

/// Points of a cloud [m]. `width`: width of the depth image whose pixels the points are, row by row, with NaN for
/// unmeasured pixels; 0: an unorganised cloud.
struct IndexedPoints {
  std::vector<Eigen::Vector3f> at_m;
  int width = 0;
};

/// Builds an index over a copy of `points`. Index::PclOrganized needs a width; with width 0 a k-d tree is built. Where
/// PCL's indexes are not set, nanoflann's index is built in their place: it finds the same neighbours.
/// Returns a shared_ptr because NeighborIndex has no public destructor: the shared_ptr keeps the deleter of the
/// concrete type.
[[nodiscard]] std::shared_ptr<const NeighborIndex> make_index(Index kind, const IndexedPoints& points);

[[nodiscard]] std::shared_ptr<const NeighborIndex> make_nanoflann_index(const IndexedPoints& points);

/// How PCL's indexes are made, in the programs that link PCL.
struct PclIndexes {
  using Make = std::shared_ptr<const NeighborIndex> (*)(const IndexedPoints& points);
  Make kdtree = nullptr;
  Make organized = nullptr;
};
/// For use_pcl_indexes() alone (pcl_indexes.h).
void set_pcl_indexes(const PclIndexes& indexes) noexcept;

}  // namespace telepalp::surface
