#pragma once

#include <memory>
#include <vector>

#include "haptic_station/surface/snapshot/surface_settings.h"
#include "tests/haptic_station/surface/analytic_surface.h"
#include "tests/haptic_station/surface/touch_scenario.h"

namespace telepalp::testing {

/// Error of a touched surface.
struct ShapeError {
  int points = 0;
  double position_rms_m = 0.0;  ///< RMS distance of the proxy from the true surface
  double position_max_m = 0.0;
  double normal_rms_deg = 0.0;
  double step_us = 0.0;  ///< median time of a step in contact
};

/// Plane, two spheres (80 and 50 mm), saddle and bump (radii ≥ 80 mm), torus (tube 50 mm), all about 0.8 m away.
[[nodiscard]] std::vector<std::unique_ptr<AnalyticSurface>> smooth_shapes();

/// Presses 3 % of the depth beyond the surface at some 80 places seen within 40 degrees, pixels `spacing_m` apart.
struct ShapeTrial {
  double spacing_m = 0.0015;
  double sigma_m = 0.0;
  int frames = 1;  ///< frames passed through one builder
};
[[nodiscard]] ShapeError shape_error(const AnalyticSurface& surface, const surface::SurfaceSettings& settings,
                                     const ShapeTrial& trial);

/// The error on a torso around `spot`, for a given snapshot.
[[nodiscard]] ShapeError torso_error(const capture::SyntheticPatient& patient, const surface::SurfaceSnapshot& snapshot,
                                     const Spot& spot);

}  // namespace telepalp::testing
