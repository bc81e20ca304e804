#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::surface {

/// Which implicit function represents the surface.
enum class Method {
  Grid,   ///< smoothed nodes on the pixel lattice of the depth image: the default
  Paper,  ///< exactly paper S1 §II.C (docs/sources.md): N neighbours within R, normals estimated per query
  Cloud,  ///< points whose normals are known before the query; for static models and unorganised clouds
};

/// The neighbour index of Paper and Cloud. Grid needs none.
enum class Index { PclKdTree, Nanoflann, PclOrganized };

/// What limits the support of Cloud's weights: `radius_m` alone, or also the distance of the `neighbors`-th neighbour.
enum class Support { FixedRadius, KthNeighbor };

/// A named choice between accuracy and computing time; telepalp-bench surface measures both for each setting.
struct SurfaceSettings {
  std::string name = "fast";
  Method method = Method::Grid;

  bool disparity_levels = true;  ///< replace rounded depths by the camera's disparity levels (SampleDepths)

  // Grid
  int node_step_px = 2;
  double support_nodes = 2.5;  ///< a node farther than this from the query's pixel has no weight [node_step_px]
  int fit_radius_px = 8;       ///< half side of the window of each node's quadratic fit
  double gate_m = 0.02;        ///< a node whose tangent plane is farther than this from the query is ignored
  double break_m = 0.015;      ///< least depth step between neighbours that is a depth break, at 1 m depth (break_at())
  int bridge_px = 2;           ///< a node in a hole is fitted if a measured pixel is at most this far away

  // over time
  bool temporal = true;          ///< average depth over frames where the patient is still; follow the motion elsewhere
  double memory_frames = 120.0;  ///< most frames in a pixel's running average; 120 at 30 Hz last about one breath
  bool predict = true;           ///< move each snapshot by prediction from its capture to now
  bool shared = true;            ///< estimate the motion common to the whole body, with its acceleration
  bool breathing = true;         ///< predict by the breathing model, too, while the body follows that model

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
