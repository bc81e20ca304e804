#pragma once

#include <memory>
#include <string>

#include "haptic_station/surface/cloud/model_fidelity.h"
#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {

/// A mesh resampled as a touchable point-set surface.
struct SampledMesh {
  std::shared_ptr<const CloudSnapshot> snapshot;
  double spacing_m = 0.0;        ///< mean spacing of the points; at thick walls, if the spacing follows the walls
  double least_spacing_m = 0.0;  ///< spacing at the thinnest walls
  double hidden = 0.0;           ///< share of the mesh's area that lies inside other parts of the mesh, and is left out
  Fidelity fidelity;
  ThinWalls thin;  ///< walls thinner than two spacings; places in the file's frame
};

/// Samples `mesh`, whose points are in metres relative to their mean. `origin_m`: this mean, in the file's frame, which
/// is the snapshot's. `settings` give the number of points or their spacing. If they give neither, the spacing is
/// reduced until the surface lies within kFaithful_m of the mesh and gives no contact in free air, until a reduction
/// leaves more than 70 % of the error, or until kMostSamples is reached. At walls thinner than two of these spacings
/// the samples are then denser (WallSpacing), as far as kMostSamples allows. `side`: 1, or -1 to reverse all normals.
/// Parts of the mesh inside other parts are left out: no finger reaches them, and they would pull the surface inwards
/// and make the proxy jump from wall to wall. Returns a null snapshot if no part of the mesh can be reached.
[[nodiscard]] SampledMesh sample_mesh(const models::PointModel& mesh, const StaticModelSettings& settings,
                                      const Eigen::Vector3d& origin_m, float side);

// Limits of Fidelity (model_fidelity.h). error_m: 99 % quantile of the distance between surface and mesh. in_air: share
// of the test points in free air that give contact. missing: share of the test points on the mesh without a surface.
inline constexpr double kFaithful_m = 0.001;   ///< a greater error_m makes sample_mesh() try more points
inline constexpr double kTooCoarse_m = 0.003;  ///< a surface with a greater error_m is refused
inline constexpr double kMostInAir = 0.002;    ///< a surface with an in_air between this and kOverlap is refused
inline constexpr double kOverlap = 0.05;       ///< a mesh with a greater in_air overlaps itself: accepted with a remark
inline constexpr double kMostMissing = 0.02;   ///< a surface with a greater `missing` is refused
inline constexpr std::size_t kMostSamples = 120'000;

[[nodiscard]] bool is_too_coarse(const Fidelity& fidelity) noexcept;

/// "16000 points 10.6 mm apart: the surface felt lies within 4.2 mm of the mesh in 99 of 100 places".
[[nodiscard]] std::string description_of(const SampledMesh& sampled);

}  // namespace telepalp::surface
