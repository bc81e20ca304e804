#pragma once

#include "haptic_station/surface/grid/grid_surface.h"

namespace telepalp::surface {

/// The nodes around a query: rows and columns of the lattice, both ends included.
struct NodeWindow {
  int first_column = 0;
  int last_column = -1;
  int first_row = 0;
  int last_row = -1;
};

/// Sums over the nodes of a window, of each node's weight times: 1, the distance of the query from the node's plane
/// [m], the node's normal, and the offset of the query from the node [m].
struct WeightedSums {
  double weight = 0.0;
  double plane = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// The gate: a factor on a node's weight that falls from 1 to 0 as the query's distance from the node's plane grows
/// from gate_m / 2 to gate_m (GridLayout). These are the sums' derivatives by the query's position through this factor.
struct GateSums {
  bool any = false;  ///< false: all derivatives are zero
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();  ///< rows: the normal; columns: the query's position
  Eigen::Matrix3d offset = Eigen::Matrix3d::Zero();
};

/// The sums of one query, and their derivatives by the query's two lattice coordinates.
struct NodeSums {
  WeightedSums value;
  WeightedSums by_column;
  WeightedSums by_row;
  double velocity = 0.0;   ///< weighted sum of the nodes' velocities along their normals [m/s]
  double deviation = 0.0;  ///< weighted sum of the nodes' standard deviations [m]
  GateSums gate;
};

/// Sums over the nodes of `window`, for a query at the lattice coordinates (`column`, `row`) and at `local`, relative
/// to the grid's origin [m]. Null `basis`: no motion. `sums` must be zero before. Each processor gives equal bits.
void sum_nodes(const GridLayout& layout, const GridNode* nodes, const NodeWindow& window, double column, double row,
               const Eigen::Vector3d& local, const MotionBasis* basis, NodeSums& sums) noexcept;

}  // namespace telepalp::surface
