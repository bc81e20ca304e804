#include <cmath>
#include <string>

#include "haptic_station/tissue/tissue_model.h"

namespace telepalp::tissue {
namespace {

/// Keeps the first error.
class Check {
 public:
  void in(const std::string& where) { where_ = where; }
  void number(const char* name, double value, const Limit& limit) {
    if (value >= limit.least && value <= limit.most) return;
    refuse(std::string(name) + " is " + text(value) + " " + limit.unit,
           "give " + text(limit.least) + " to " + text(limit.most) + " " + limit.unit);
  }
  void refuse(const std::string& what, const std::string& fix) {
    if (!error_) error_ = Error{.what = what, .where = where_, .fix = fix};
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  static std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%g", value);
    return digits;
  }
  std::string where_ = "tissue";
  std::optional<Error> error_;
};

void check_surface(Check& check, const SurfaceSettings& surface) {
  check.number("stiffness_N_per_m", surface.stiffness_N_per_m, limits::kStiffness_N_per_m);
  check.number("stiffening_N_per_m2", surface.stiffening_N_per_m2, limits::kStiffening_N_per_m2);
  check.number("punctures_at_N", surface.punctures_at_N, limits::kPuncturesAt_N);
  check.number("friction_N", surface.friction_N, limits::kFriction_N);
  check.number("bristle_N_per_m", surface.bristle_N_per_m, limits::kBristle_N_per_m);
  check.number("side_grip", surface.side_grip, limits::kSideGrip);
  check.number("falls_in_s", surface.falls_in_s, limits::kFallsIn_s);
}

void check_bulk(Check& check, const BulkSettings& bulk) {
  check.number("stick_N_per_m", bulk.stick_N_per_m, limits::kStick_N_per_m);
  check.number("slips_at_N", bulk.slips_at_N, limits::kSlipsAt_N);
  check.number("slips_at_N_per_m", bulk.slips_at_N_per_m, limits::kSlipsAt_N_per_m);
  check.number("cuts_at_N", bulk.cuts_at_N, limits::kCutsAt_N);
  check.number("damping_N_s_per_m", bulk.damping_N_s_per_m, limits::kDamping_N_s_per_m);
  check.number("resolution_m", bulk.resolution_m, limits::kResolution_m);
  check.number("equal_readings", bulk.equal_readings, limits::kEqualReadings);
  if (bulk.law != BulkLaw::Bristle && !(bulk.slips_at_N > 0.0))
    check.refuse("slips_at_N is 0, and stick and slip need a threshold", "give slips_at_N above 0 N");
}

void check_relaxation(Check& check, const Relaxation& relaxation) {
  double sum = 0.0;
  if (relaxation.branches < 0 || relaxation.branches > Relaxation::kMost)
    return check.refuse("the layer has more than 4 branches of relaxation", "give at most 4");
  for (int i = 0; i < relaxation.branches; ++i) {
    check.number("relaxation's share", relaxation.share[i], limits::kShare);
    check.number("relaxation's time_s", relaxation.time_s[i], limits::kTime_s);
    sum += relaxation.share[i];
  }
  if (sum > 1.0 + 1e-9) check.refuse("the shares of relaxation sum to more than 1", "let them sum to at most 1");
}

void check_layer(Check& check, const LayerSettings& layer, const LayerSettings* before) {
  check.in("tissue layer \"" + layer.name + "\"");
  check.number("top_m", layer.top_m, limits::kTop_m);
  check.number("thickness_m", layer.thickness_m, limits::kThickness_m);
  if (before != nullptr && layer.top_m < before->top_m + before->thickness_m - 1e-12)
    check.refuse("the layer begins above the end of the layer \"" + before->name + "\"",
                 "list layers from the outside in, and let top_m be at least top_m + thickness_m of the one before");
  if (!layer.surface && !layer.bulk) check.refuse("the layer has neither a surface nor a bulk", "give one of them");
  if (layer.bulk && !(layer.thickness_m > 0.0))
    check.refuse("the layer has a bulk and no thickness", "give thickness_m above 0 m");
  if (layer.surface) check_surface(check, *layer.surface);
  if (layer.bulk) check_bulk(check, *layer.bulk);
  check_relaxation(check, layer.relaxation);
}

void check_layers(Check& check, const TissueSettings& settings) {
  if (settings.layers.empty()) check.refuse("the tissue has no layer", "give at least one layer");
  if (settings.layers.size() > TissueSettings::kMostLayers)
    check.refuse("the tissue has more than 12 layers", "leave some out");
  const LayerSettings* before = nullptr;
  for (const LayerSettings& layer : settings.layers) {
    check_layer(check, layer, before);
    before = &layer;
  }
}

}  // namespace

std::optional<Error> layer_fault(const LayerSettings& layer, const LayerSettings* before) {
  Check check;
  check_layer(check, layer, before);
  return check.error();
}

Result<std::shared_ptr<const TissueModel>> make_tissue(TissueSettings settings) {
  Check check;
  for (int axis = 0; axis < 3; ++axis) check.number("at_m", settings.at_m[axis], limits::kAt_m);
  check.number("net_radius_m", settings.net_radius_m, limits::kNetRadius_m);
  check.number("net_edge_m", settings.net_edge_m, limits::kNetEdge_m);
  check.number("spread_m", settings.net.spread_m, limits::kSpread_m);
  check.number("subdivisions", settings.net.subdivisions, limits::kSubdivisions);
  check.number("side_N_per_m", settings.shaft.side_N_per_m, limits::kSide_N_per_m);
  check.number("tears_at_N_per_m", settings.shaft.tears_at_N_per_m, limits::kTearsAt_N_per_m);
  check.number("bevel_rad", settings.shaft.bevel_rad, limits::kBevel_rad);
  const double rings = settings.net_radius_m / settings.net_edge_m;
  if (!settings.mesh && !(rings >= 3.0 && rings <= 40.0))
    check.refuse("net_radius_m is not 3 to 40 times net_edge_m", "give an edge that fits the radius");
  check_layers(check, settings);
  if (check.error()) return *check.error();
  SurfaceMesh mesh = settings.mesh ? *settings.mesh : lattice_disc(settings.net_radius_m, settings.net_edge_m);
  return std::shared_ptr<const TissueModel>(std::make_shared<TissueModel>(settings, std::move(mesh)));
}

}  // namespace telepalp::tissue
