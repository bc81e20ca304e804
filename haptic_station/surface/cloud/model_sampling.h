#pragma once

#include <memory>
#include <string>

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {

/// How far the touched surface lies from the mesh that it was sampled from, at places that are picked
/// half by area and half by face, since small features have small faces.
struct Fidelity {
  double error_m = 0.0;  ///< in 99 of 100 places at most
  double missing = 0.0;  ///< share of the places where nothing can be touched
  double in_air = 0.0;   ///< share of the places 3 to 15 mm above the mesh where contact is felt
};

/// A mesh as points to touch.
struct SampledMesh {
  std::shared_ptr<const CloudSnapshot> snapshot;
  double spacing_m = 0.0;  ///< the side of the cell that a point has to itself
  Fidelity fidelity;
};

/// Samples `mesh` (in metres around its own middle) as often as `settings` ask: `samples` points, or points
/// `spacing_m` apart, or, where neither is given, as many as its area and its smallest features need: the spacing is
/// reduced until the surface lies within kFaithful_m of the mesh, or kMostSamples is reached. `side` -1 turns all
/// normals over. Contact in free air is only looked for where the mesh is `closed`: of an open one nobody can tell
/// which side is air.
[[nodiscard]] SampledMesh sample_mesh(const models::PointModel& mesh, const StaticModelSettings& settings,
                                      const Eigen::Vector3d& origin_m, float side, bool closed);

inline constexpr double kFaithful_m = 0.001;
inline constexpr double kTooCoarse_m = 0.003;  ///< a surface that lies further beside the mesh is refused
inline constexpr double kMostInAir = 0.002;    ///< as is one that is felt in free air more often
inline constexpr double kOverlap = 0.05;       ///< felt there more often still, the mesh overlaps itself
inline constexpr double kMostMissing = 0.02;   ///< as is one with more holes
inline constexpr std::size_t kMostSamples = 120'000;

[[nodiscard]] bool is_too_coarse(const Fidelity& fidelity) noexcept;

/// "16000 points 10.6 mm apart: the surface felt lies within 4.2 mm of the mesh in 99 of 100 places".
[[nodiscard]] std::string description_of(const SampledMesh& sampled);

}  // namespace telepalp::surface
