#pragma once

#include <memory>
#include <string>

#include "haptic_station/tissue/fem/elastic_motion.h"
#include "haptic_station/tissue/fem/prism_mesh.h"
#include "haptic_station/tissue/settings_limits.h"
#include "proto/words/result.h"

namespace telepalp::tissue {

/// A soft prism that stands on its fixed bottom and is pushed at its sides and top: paper S3 (docs/sources.md), 8.4.
struct PrismSettings {
  std::string name{};
  PrismGrid grid{};
  Eigen::Vector3d foot_m = Eigen::Vector3d::Zero();  ///< in H: the middle of the bottom
  double top_N_per_m = 1400.0;                       ///< S3's stiffness: of the top, along x; see top_stiffness()
  double poisson = 0.45;
  double density_kg_per_m3 = 1000.0;
  double damping_per_s = 40.0;  ///< ElasticMotion's
  double spread_m = 0.008;  ///< the tool's load is spread over this radius: a point load has no limit as meshes refine
  double coupling_N_per_m = 0.0;  ///< S3's virtual coupling between tool and hand, in series; 0: rigid
  double lets_go_N = 40.0;        ///< a tool that pushes harder passes through the prism
};

/// One limit for each number of PrismSettings, under its name.
namespace limits {
inline constexpr Limit kSize_m{0.005, 0.3, "m"};
inline constexpr Limit kAcross{1, 4, "cells"};
inline constexpr Limit kAlong{1, 20, "cells"};
inline constexpr Limit kTop_N_per_m{10, 20000, "N/m"};
inline constexpr Limit kPoisson{0, 0.49, ""};
inline constexpr Limit kDensity_kg_per_m3{100, 10000, "kg/m^3"};
inline constexpr Limit kDamping_per_s{0, 1000, "1/s"};
inline constexpr Limit kPrismSpread_m{0.002, 0.05, "m"};
inline constexpr Limit kCoupling_N_per_m{10, 20000, "N/m"};
inline constexpr Limit kLetsGo_N{1, 1000, "N"};
}  // namespace limits

/// What all steps share. Immutable.
struct PrismModel {
  PrismSettings settings;
  double young_Pa = 0.0;  ///< Young's modulus that gives PrismSettings::top_N_per_m
  std::shared_ptr<const ElasticBody> body;
};

/// Solves one linear problem for Young's modulus. Error: a number out of its limits; `where` is "prism".
[[nodiscard]] Result<std::shared_ptr<const PrismModel>> make_prism_model(const PrismSettings& settings);

/// The whole top, with equal shares for equal areas.
[[nodiscard]] Patch top_of(const TetMesh& mesh);
/// Part of a side around `center_m`, which lies on it at rest, with the weight (1 - (r / radius)^2)^2 at the distance
/// r.
[[nodiscard]] Patch patch_around(const TetMesh& mesh, PrismSide side, const Eigen::Vector3d& center_m, double radius_m);
/// Lateral stiffness of the top of a body at rest: a force along x, spread evenly over the top, over the top's mean
/// displacement along x [N/m].
[[nodiscard]] double top_stiffness_N_per_m(const std::shared_ptr<const ElasticBody>& body);

/// A tessellation of a side in flat triangles, as nodes of the mesh.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> flat_triangles(const TetMesh& mesh, PrismSide side);

}  // namespace telepalp::tissue
