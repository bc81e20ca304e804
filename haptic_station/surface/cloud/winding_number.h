#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptic_station/surface/cloud/cloud_surface.h"
#include "support/models/point_model.h"

namespace telepalp::surface {

/// How often a surface winds around a point: 1 inside a closed surface whose normals point outwards, 0 outside, 2 where
/// two bodies overlap. At an open surface the number is a fraction: one half behind a large sheet, minus one half in
/// front of it. Triangles near the query are summed exactly, distant groups as one dipole each. Accuracy: 0.03.
/// Source: Jacobson et al. 2013 (triangles), Barill et al. 2018 (groups and point clouds).
class WindingNumber {
 public:
  explicit WindingNumber(const models::PointModel& mesh);
  /// Point i stands for a disc of areas_m2[i]. Accuracy: 0.1 at distances above 1.5 spacings from the cloud.
  WindingNumber(const std::vector<CloudPoint>& cloud, const std::vector<double>& areas_m2);

  [[nodiscard]] double at(const Eigen::Vector3d& query) const;

 private:
  /// A triangle, a disc around a point of a cloud, or a group of either. `triangle`: index in corners_.
  struct Patch {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d area = Eigen::Vector3d::Zero();  ///< along the normal [m2]
    double radius = 0.0;
    std::uint32_t triangle = 0;
  };
  /// A node of the tree: patches `from` to `to` - 1. A leaf has at most kLeaf patches (winding_number.cpp).
  struct Node {
    Patch sum;
    std::uint32_t from = 0, to = 0;
    std::uint32_t left = 0, right = 0;  ///< indices in nodes_; 0: a leaf
  };

  void build();
  std::uint32_t add_node(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] Patch sum_of(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] double of_patch(const Patch& patch, const Eigen::Vector3d& query) const;

  std::vector<Patch> patches_;
  std::vector<std::array<Eigen::Vector3d, 3>> corners_;  // of each triangle; empty for a cloud
  std::vector<Node> nodes_;
};

}  // namespace telepalp::surface
