#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::surface {

/// Which implicit function represents the surface.
enum class Method {
  Grid,   ///< smoothed nodes on the depth image's own lattice: the default
  Paper,  ///< exactly paper S1 §II.C (docs/sources.md): N neighbours within R, normals estimated per query
  Cloud,  ///< points whose normals are known before the query; for static models and unorganised clouds
};

/// The neighbour index of Paper and Cloud. Grid needs none.
enum class Index { PclKdTree, Nanoflann, PclOrganized };

/// How the support of Cloud's weights is chosen.
enum class Support { FixedRadius, KthNeighbor };

/// A named choice between accuracy and time. telepalp-bench surface measures the cost and the error of each setting.
struct SurfaceSettings {
  std::string name = "fast";
  Method method = Method::Grid;

  bool disparity_levels = true;  ///< undo the rounding of a disparity sensor's depths, if the images show its levels

  // Grid
  int node_step_px = 2;
  double support_nodes = 2.5;  ///< a node farther than this from the query's pixel has no weight [nodes]
  int fit_radius_px = 8;       ///< half side of the window of each node's quadratic fit
  double gate_m = 0.02;        ///< a node whose tangent plane is farther than this from the query is ignored
  double break_m = 0.015;  ///< depth step between neighbours that separates surfaces at a depth of 1 m; grows with z²
  int bridge_px = 2;       ///< holes of at most this radius are bridged

  // over time
  bool temporal = true;          ///< average depth over frames where the patient is still; follow the motion elsewhere
  double memory_frames = 120.0;  ///< most frames in a pixel's running average: about one breath
  bool predict = true;           ///< predict each snapshot forward by its velocity
  bool shared = true;            ///< estimate the motion common to the whole body, with its acceleration
  bool breathing = true;         ///< predict by the breathing model, too, while it follows the breath

  // Paper and Cloud
  Index index = Index::PclKdTree;
  int neighbors = 10;     ///< N; Cloud uses it with Support::KthNeighbor only
  double radius_m = 0.1;  ///< R: search radius, at which the weights reach zero
  Support support = Support::FixedRadius;
};

/// The setting called `name`. The error for an unknown name lists all names.
[[nodiscard]] Result<SurfaceSettings> surface_settings(std::string_view name);
[[nodiscard]] std::vector<SurfaceSettings> all_surface_settings();

/// True when the haptic thread may evaluate snapshots of this setting. Paper allocates at each query, and so may the
/// index of Cloud.
[[nodiscard]] constexpr bool runs_in_tick(const SurfaceSettings& settings) noexcept {
  return settings.method == Method::Grid;
}

}  // namespace telepalp::surface
