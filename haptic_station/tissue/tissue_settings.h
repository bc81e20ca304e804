#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/tissue/net/stiffness_map.h"
#include "haptic_station/tissue/relaxing_spring.h"
#include "haptic_station/tissue/settings_limits.h"
#include "proto/words/result.h"

namespace telepalp::tissue {

/// The upper side of a layer: a tense net of springs that the tip deforms and punctures (paper S4, docs/sources.md,
/// section 3, eq. 2, 3, 6 and 7).
struct SurfaceSettings {
  double stiffness_N_per_m =
      300.0;  ///< of the net at its middle, under a load that is spread over NetSettings::spread_m
  double stiffening_N_per_m2 = 0.0;  ///< a_2 of F = a_1 d + a_2 d^2 (Mahvash and Dupont 2010)
  double punctures_at_N = 2.5;       ///< force of the puncture: S4's threshold of |F_l1| and |F_l3|
  double friction_N = 0.3;           ///< friction of the hole: C_1 of eq. (3) and C_3 of eq. (7)
  double bristle_N_per_m = 1000.0;   ///< stiffness of the hole's friction before it slips
  double side_grip = 0.6;    ///< greatest ratio of sideways force to force along the normal before the tip slides
  double falls_in_s = 0.02;  ///< how long the force takes to fall after the puncture
};

/// How a layer with thickness holds the needle that moves in it.
enum class BulkLaw {
  Bristle,  ///< an elasto-plastic bristle (bristle.h)
  Window,   ///< S4 eq. (4) and (5); "stopped" is judged by the mean speed over 20 ms
  Paper,    ///< S4 as printed; "stopped" is judged by a run of equal coordinates of a device with a stated resolution
};

struct BulkSettings {
  BulkLaw law = BulkLaw::Bristle;
  double stick_N_per_m = 1000.0;  ///< K_l2 of eq. (4), or the stiffness of the bristle
  double slips_at_N = 0.3;        ///< constant part of the force at which it slips (threshold of eq. 4)
  double slips_at_N_per_m = 0.0;  ///< part of that force for each metre of the needle in this layer
  double cuts_at_N = 0.0;  ///< greatest force of cutting, while the tip goes forward in uncut tissue of this layer
  double damping_N_s_per_m = 4.0;  ///< D_l2 of eq. (5)
  double resolution_m = 3e-5;      ///< BulkLaw::Paper: resolution of the device's coordinates
  int equal_readings = 20;         ///< BulkLaw::Paper: successive equal coordinates that mean "stopped"
};

struct LayerSettings {
  std::string name;
  double top_m = 0.0;        ///< depth of its upper side below TissueSettings::at_m
  double thickness_m = 0.0;  ///< 0: a surface alone
  std::optional<SurfaceSettings> surface;
  std::optional<BulkSettings> bulk;
  Relaxation relaxation;
};

/// The part of the needle above the tip. The hole in the outermost layer holds it sideways.
struct ShaftSettings {
  double side_N_per_m = 0.0;       ///< 0: the hole does not hold the needle
  double tears_at_N_per_m = 20.0;  ///< greatest sideways force for each metre inside; beyond, the hole gets longer
  double bevel_rad = 0.0;          ///< tip's bevel: the force of cutting turns by this angle towards +x of the tool
};

struct TissueSettings {
  static constexpr int kMostLayers = 12;
  Eigen::Vector3d at_m = Eigen::Vector3d::Zero();  ///< H: middle of the plane from which layers are measured; +y is out
  double net_radius_m = 0.03;
  double net_edge_m = 0.0035;
  NetSettings net;
  std::shared_ptr<const SurfaceMesh> mesh;  ///< relative to at_m and the layer's top; nullptr: a level disc
  std::vector<LayerSettings> layers;        ///< from the outside in
  ShaftSettings shaft;
};

/// What all ticks share: the settings, the mesh and its stiffness. Immutable; made by make_tissue().
struct TissueModel;

[[nodiscard]] const TissueSettings& settings_of(const TissueModel& model) noexcept;

/// The first fault of a layer. `before`: the next layer outwards, below which it must begin; nullptr: there is none.
[[nodiscard]] std::optional<Error> layer_fault(const LayerSettings& layer, const LayerSettings* before);

/// Error: a value is not a number or out of range, a layer begins above the end of the one before it, the mesh is bad,
/// or there are no or too many layers. `where` names the layer.
[[nodiscard]] Result<std::shared_ptr<const TissueModel>> make_tissue(TissueSettings settings);

}  // namespace telepalp::tissue
