#pragma once

#include <memory>

#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "support/models/point_model.h"

namespace telepalp::surface {

struct StaticModelSettings {
  double unit_m = 1.0;          ///< metres for one unit of the file
  std::size_t samples = 16000;  ///< of a mesh, spread evenly (S2's mannequin had as many)
  std::uint64_t seed = 1;
  int normal_neighbors = 16;                              ///< of clouds without normals
  Eigen::Vector3d viewpoint_m = Eigen::Vector3d::Zero();  ///< where normals of such clouds look to
  double support_m = 0.0;                                 ///< 0: three times the spacing
  bool flip_normals = false;                              ///< the other side is outside
};

/// What became of a model, for the person who gave it.
struct StaticModel {
  std::shared_ptr<const CloudSnapshot> snapshot;
  std::string remarks;  ///< open, inverted, without normals …; empty when there is nothing to say
};

/// A mesh or cloud as a surface to touch, in the file's own frame. A mesh is resampled to `samples` points by
/// Poisson-disk elimination, with its vertices' normals interpolated, or its faces' where it has none; a closed mesh
/// whose normals look inwards is turned over; of an open one nobody can tell. A cloud keeps its points, and its normals
/// where it has them. An error when nothing is left that has a normal, or the coordinates cannot be metres.
[[nodiscard]] Result<StaticModel> make_static_model(const models::PointModel& model,
                                                    const StaticModelSettings& settings);

/// Whether a model has three finite points that are neither in one place nor on one line.
[[nodiscard]] bool spans_a_surface(const models::PointModel& model);
[[nodiscard]] Error no_surface();

/// `count` points on the triangles, no two nearer than a blue-noise spacing allows: four times as many random points by
/// area, thinned by dropping the most crowded first. Source: Yuksel 2015, sample elimination.
[[nodiscard]] std::vector<CloudPoint> poisson_disk_samples(const models::PointModel& model, std::size_t count,
                                                           std::uint64_t seed);

}  // namespace telepalp::surface
