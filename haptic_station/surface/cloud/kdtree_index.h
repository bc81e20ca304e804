#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/cloud/neighbor_index.h"
#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"

namespace telepalp::surface {

/// Points of a cloud, and, where they come from a depth image, its width (0: no order; not measured points are NaN).
struct IndexedPoints {
  std::vector<Eigen::Vector3f> at_m;
  int width = 0;
};

/// Builds an index over `points`, which it copies or keeps. PclOrganized asks for a width; without one it is a tree.
/// A shared_ptr, so that the deleter of the index's own type travels with it.
[[nodiscard]] std::shared_ptr<const NeighborIndex> make_index(Index kind, const IndexedPoints& points);

/// The parts of make_index, each in its own translation unit, since their headers are heavy.
[[nodiscard]] std::shared_ptr<const NeighborIndex> make_nanoflann_index(const IndexedPoints& points);
[[nodiscard]] std::shared_ptr<const NeighborIndex> make_pcl_kdtree_index(const IndexedPoints& points);
[[nodiscard]] std::shared_ptr<const NeighborIndex> make_pcl_organized_index(const IndexedPoints& points);

}  // namespace telepalp::surface
