#pragma once

#include <memory>
#include <string>

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {

/// Errors of the touched surface against the mesh from which it was sampled, at random test points. Half of the points
/// are drawn by area and half by face, because small features have small faces.
struct Fidelity {
  double error_m = 0.0;  ///< 99 % quantile of the distance between surface and mesh
  double missing = 0.0;  ///< share of test points without a touchable surface
  double in_air = 0.0;   ///< share of points 3 to 15 mm above the mesh with a false contact
};

/// A mesh resampled as a touchable point-set surface.
struct SampledMesh {
  std::shared_ptr<const CloudSnapshot> snapshot;
  double spacing_m = 0.0;  ///< mean spacing of the points
  Fidelity fidelity;
};

/// Samples `mesh`, in metres around its middle. `settings` give the number of points or their spacing. If they give
/// neither, the spacing is reduced until the surface lies within kFaithful_m of the mesh or kMostSamples is reached.
/// `side` -1 reverses all normals. False contacts are only counted for a `closed` mesh, because an open mesh does not
/// define which side is air.
[[nodiscard]] SampledMesh sample_mesh(const models::PointModel& mesh, const StaticModelSettings& settings,
                                      const Eigen::Vector3d& origin_m, float side, bool closed);

inline constexpr double kFaithful_m = 0.001;
inline constexpr double kTooCoarse_m = 0.003;  ///< a surface with a greater error_m is refused
inline constexpr double kMostInAir = 0.002;    ///< a surface with a greater in_air is refused
inline constexpr double kOverlap = 0.05;       ///< a greater in_air means that the mesh overlaps itself
inline constexpr double kMostMissing = 0.02;   ///< a surface with a greater `missing` is refused
inline constexpr std::size_t kMostSamples = 120'000;

[[nodiscard]] bool is_too_coarse(const Fidelity& fidelity) noexcept;

/// "16000 points 10.6 mm apart: the surface felt lies within 4.2 mm of the mesh in 99 of 100 places".
[[nodiscard]] std::string description_of(const SampledMesh& sampled);

}  // namespace telepalp::surface
