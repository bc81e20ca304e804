#include <cmath>
#include <numbers>
#include <string>

#include "haptic_station/tissue/tissue_model.h"

namespace telepalp::tissue {
namespace {

/// Keeps the first error.
class Check {
 public:
  void in(const std::string& where) { where_ = where; }
  void number(const char* name, double value, double least, double most, const char* unit) {
    if (value >= least && value <= most) return;
    refuse(std::string(name) + " is " + text(value) + " " + unit,
           "give " + text(least) + " to " + text(most) + " " + unit);
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
  check.number("stiffness_N_per_m", surface.stiffness_N_per_m, 1, 20000, "N/m");
  check.number("stiffening_N_per_m2", surface.stiffening_N_per_m2, 0, 1e6, "N/m^2");
  check.number("punctures_at_N", surface.punctures_at_N, 0.01, 1e9, "N");
  check.number("friction_N", surface.friction_N, 0, 10, "N");
  check.number("bristle_N_per_m", surface.bristle_N_per_m, 10, 20000, "N/m");
  check.number("side_grip", surface.side_grip, 0, 3, "N/N");
  check.number("falls_in_s", surface.falls_in_s, 0.002, 0.5, "s");
}

void check_bulk(Check& check, const BulkSettings& bulk) {
  check.number("stick_N_per_m", bulk.stick_N_per_m, 10, 20000, "N/m");
  check.number("slips_at_N", bulk.slips_at_N, 0, 20, "N");
  check.number("slips_at_N_per_m", bulk.slips_at_N_per_m, 0, 500, "N/m");
  check.number("cuts_at_N", bulk.cuts_at_N, 0, 20, "N");
  check.number("damping_N_s_per_m", bulk.damping_N_s_per_m, 0, 100, "N s/m");
  check.number("resolution_m", bulk.resolution_m, 1e-7, 0.01, "m");
  check.number("equal_readings", bulk.equal_readings, 1, 2000, "");
  if (bulk.law != BulkLaw::Bristle && !(bulk.slips_at_N > 0.0))
    check.refuse("slips_at_N is 0, and stick and slip need a threshold", "give slips_at_N above 0 N");
}

void check_relaxation(Check& check, const Relaxation& relaxation) {
  double sum = 0.0;
  if (relaxation.branches < 0 || relaxation.branches > Relaxation::kMost)
    return check.refuse("the layer has more than 4 branches of relaxation", "give at most 4");
  for (int i = 0; i < relaxation.branches; ++i) {
    check.number("relaxation's share", relaxation.share[i], 0, 1, "N/N");
    check.number("relaxation's time_s", relaxation.time_s[i], 0.02, 1000, "s");
    sum += relaxation.share[i];
  }
  if (sum > 1.0 + 1e-9) check.refuse("the shares of relaxation sum to more than 1", "let them sum to at most 1");
}

void check_layers(Check& check, const TissueSettings& settings) {
  if (settings.layers.empty()) check.refuse("the tissue has no layer", "give at least one layer");
  if (settings.layers.size() > TissueSettings::kMostLayers)
    check.refuse("the tissue has more than 12 layers", "leave some out");
  double end_m = 0.0;
  std::string before;
  for (const LayerSettings& layer : settings.layers) {
    check.in("tissue layer \"" + layer.name + "\"");
    check.number("top_m", layer.top_m, 0, 0.3, "m");
    check.number("thickness_m", layer.thickness_m, 0, 0.3, "m");
    if (layer.top_m < end_m - 1e-12)
      check.refuse("the layer begins above the end of the layer \"" + before + "\"",
                   "list layers from the outside in, and let top_m be at least top_m + thickness_m of the one before");
    if (!layer.surface && !layer.bulk) check.refuse("the layer has neither a surface nor a bulk", "give one of them");
    if (layer.bulk && !(layer.thickness_m > 0.0))
      check.refuse("the layer has a bulk and no thickness", "give thickness_m above 0 m");
    if (layer.surface) check_surface(check, *layer.surface);
    if (layer.bulk) check_bulk(check, *layer.bulk);
    check_relaxation(check, layer.relaxation);
    end_m = layer.top_m + layer.thickness_m;
    before = layer.name;
  }
}

}  // namespace

Result<std::shared_ptr<const TissueModel>> make_tissue(TissueSettings settings) {
  Check check;
  for (int axis = 0; axis < 3; ++axis) check.number("at_m", settings.at_m[axis], -10, 10, "m");
  check.number("net_radius_m", settings.net_radius_m, 0.005, 0.2, "m");
  check.number("net_edge_m", settings.net_edge_m, 0.001, 0.05, "m");
  check.number("spread_m", settings.net.spread_m, 0.001, 0.05, "m");
  check.number("subdivisions", settings.net.subdivisions, 0, 3, "");
  check.number("side_N_per_m", settings.shaft.side_N_per_m, 0, 5000, "N/m");
  check.number("tears_at_N_per_m", settings.shaft.tears_at_N_per_m, 0, 1000, "N/m");
  check.number("bevel_rad", settings.shaft.bevel_rad, -std::numbers::pi / 3, std::numbers::pi / 3, "rad");
  const double rings = settings.net_radius_m / settings.net_edge_m;
  if (!settings.mesh && !(rings >= 3.0 && rings <= 40.0))
    check.refuse("net_radius_m is not 3 to 40 times net_edge_m", "give an edge that fits the radius");
  check_layers(check, settings);
  if (check.error()) return *check.error();
  SurfaceMesh mesh = settings.mesh ? *settings.mesh : lattice_disc(settings.net_radius_m, settings.net_edge_m);
  return std::shared_ptr<const TissueModel>(std::make_shared<TissueModel>(settings, std::move(mesh)));
}

}  // namespace telepalp::tissue
