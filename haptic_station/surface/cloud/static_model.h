#pragma once

#include <functional>
#include <memory>

#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "support/models/point_model.h"

namespace telepalp::surface {

struct StaticModelSettings {
  double unit_m = 1.0;      ///< metres for one unit of the file
  std::size_t samples = 0;  ///< number of points sampled from a mesh; 0: it follows from `spacing_m`
  double spacing_m = 0.0;   ///< spacing of a mesh's samples; 0: refined until the surface fits the mesh
  bool anyway = false;  ///< accept too coarse samples, a too noisy cloud, or normals that contradict their neighbours
  std::uint64_t seed = 1;                                 ///< of a mesh's random samples
  int normal_neighbors = 16;                              ///< smallest number of neighbours per estimated normal
  Eigen::Vector3d viewpoint_m = Eigen::Vector3d::Zero();  ///< in the file's frame; estimated normals point towards it
  double support_m = 0.0;     ///< a point farther from the query has no weight; 0: three spacings, more for noise
  bool flip_normals = false;  ///< reverse all normals; of a closed model only with `anyway`
  /// Called with a line for the user before each step that takes seconds.
  std::function<void(const std::string&)> on_progress{};
};

/// The surface of a model, with remarks for the user.
struct StaticModel {
  std::shared_ptr<const CloudSnapshot> snapshot;
  std::string remarks;      ///< such as that the mesh is open, was inverted or had no normals; may be empty
  std::string sampling;     ///< of a mesh: spacing and error of its samples; of a cloud: spacing, noise and support
  double thin_share = 0.0;  ///< of a mesh: share of its surface with walls thinner than two spacings of the samples
};

/// Makes a touchable surface from a mesh or cloud, in the frame of the file. A mesh is resampled by Poisson-disk sample
/// elimination, with vertex normals, or face normals if it has no vertex normals. Faces that are oriented against their
/// neighbours are reversed. A closed mesh with inward normals is inverted; an open mesh is not. A very noisy cloud
/// is thinned at random. A cloud keeps its normals if they agree with the points, else normals are estimated; see
/// touched_cloud(). Error: no point has a normal, the coordinates cannot be metres, or `anyway` is not set and the
/// samples are too coarse for the mesh, the cloud is too noisy, the normals of an open cloud contradict each other
/// or the points, or the normals of a closed model are to be flipped.
[[nodiscard]] Result<StaticModel> make_static_model(const models::PointModel& model,
                                                    const StaticModelSettings& settings);

/// True when the model has three finite points that are not collinear. no_surface(): the error for any other model.
[[nodiscard]] bool spans_a_surface(const models::PointModel& model);
[[nodiscard]] Error no_surface();

/// Adds `remark` to the remarks of a model, behind a semicolon if it is not the first.
void add_remark(std::string& remarks, const std::string& remark);

/// flip_normals of a closed model, whose outside is certain: the error, and the remark if `anyway` accepts it. `what`:
/// "mesh" or "cloud".
[[nodiscard]] Error inside_out(const std::string& what);
[[nodiscard]] std::string touched_from_inside(const std::string& what);

/// Samples `count` points on the triangles with Poisson-disk spacing: draws 4 × `count` area-weighted random points and
/// removes the most crowded ones first. Source: Yuksel 2015, sample elimination.
[[nodiscard]] std::vector<CloudPoint> poisson_disk_samples(const models::PointModel& model, std::size_t count,
                                                           std::uint64_t seed);

/// The wanted spacing of samples [m] at a place of the model.
using SpacingAt = std::function<double(const Eigen::Vector3f& place)>;

/// As poisson_disk_samples(), with a spacing that differs from place to place. The number of points follows from it.
[[nodiscard]] std::vector<CloudPoint> graded_samples(const models::PointModel& model, const SpacingAt& spacing_m,
                                                     std::uint64_t seed);

/// `count` random points on the triangles, by area. Empty for a mesh without area.
[[nodiscard]] std::vector<CloudPoint> random_samples(const models::PointModel& model, std::size_t count,
                                                     std::uint64_t seed);

/// The centres of about `count` triangles, picked evenly from the list of triangles. Most of them lie on small
/// features, where the mesh is fine.
[[nodiscard]] std::vector<CloudPoint> face_middles(const models::PointModel& model, std::size_t count);

/// Area of all triangles with finite corners, in square metres if the model is in metres.
[[nodiscard]] double area_of(const models::PointModel& model);

}  // namespace telepalp::surface
