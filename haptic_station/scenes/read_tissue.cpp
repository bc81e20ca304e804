#include "haptic_station/scenes/read_tissue.h"

#include "haptic_station/scenes/number_reader.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::scenes {
namespace {

using TissueEffect = msg::LayeredTissueEffect;
namespace limits = tissue::limits;

tissue::SurfaceSettings read_surface(FieldCheck& check, const TissueEffect::Surface& given) {
  tissue::SurfaceSettings surface;
  const NumberReader read{check, given, "surface."};
  read(given.has_stiffness_n_per_m(), "stiffness_N_per_m", given.stiffness_n_per_m(), limits::kStiffness_N_per_m,
       surface.stiffness_N_per_m);
  read(given.has_stiffening_n_per_m2(), "stiffening_N_per_m2", given.stiffening_n_per_m2(),
       limits::kStiffening_N_per_m2, surface.stiffening_N_per_m2);
  read(given.has_punctures_at_n(), "punctures_at_N", given.punctures_at_n(), limits::kPuncturesAt_N,
       surface.punctures_at_N);
  read(given.has_friction_n(), "friction_N", given.friction_n(), limits::kFriction_N, surface.friction_N);
  read(given.has_bristle_n_per_m(), "bristle_N_per_m", given.bristle_n_per_m(), limits::kBristle_N_per_m,
       surface.bristle_N_per_m);
  read(given.has_side_grip(), "side_grip", given.side_grip(), limits::kSideGrip, surface.side_grip);
  read(given.has_falls_in_s(), "falls_in_s", given.falls_in_s(), limits::kFallsIn_s, surface.falls_in_s);
  return surface;
}

tissue::BulkLaw law_of(TissueEffect::Law law) {
  if (law == TissueEffect::LAW_WINDOW) return tissue::BulkLaw::Window;
  return law == TissueEffect::LAW_PAPER ? tissue::BulkLaw::Paper : tissue::BulkLaw::Bristle;
}

tissue::BulkSettings read_bulk(FieldCheck& check, const TissueEffect::Bulk& given) {
  tissue::BulkSettings bulk{.law = law_of(given.law())};
  const NumberReader read{check, given, "bulk."};
  read(given.has_stick_n_per_m(), "stick_N_per_m", given.stick_n_per_m(), limits::kStick_N_per_m, bulk.stick_N_per_m);
  read(given.has_slips_at_n(), "slips_at_N", given.slips_at_n(), limits::kSlipsAt_N, bulk.slips_at_N);
  read(given.has_slips_at_n_per_m(), "slips_at_N_per_m", given.slips_at_n_per_m(), limits::kSlipsAt_N_per_m,
       bulk.slips_at_N_per_m);
  read(given.has_cuts_at_n(), "cuts_at_N", given.cuts_at_n(), limits::kCutsAt_N, bulk.cuts_at_N);
  read(given.has_damping_n_s_per_m(), "damping_N_s_per_m", given.damping_n_s_per_m(), limits::kDamping_N_s_per_m,
       bulk.damping_N_s_per_m);
  read(given.has_resolution_m(), "resolution_m", given.resolution_m(), limits::kResolution_m, bulk.resolution_m);
  read(given.has_equal_readings(), "equal_readings", given.equal_readings(), limits::kEqualReadings,
       bulk.equal_readings);
  return bulk;
}

tissue::Relaxation read_relaxation(FieldCheck& check, const TissueEffect::Layer& given) {
  tissue::Relaxation relaxation;
  for (const TissueEffect::Relaxation& branch : given.relaxation()) {
    if (relaxation.branches == tissue::Relaxation::kMost) {
      check.in(branch).complain("a layer has more than 4 branches of relaxation", "give at most 4");
      break;
    }
    const auto i = static_cast<std::size_t>(relaxation.branches++);
    check.in(branch).number("relaxation.share", branch.share(), within(limits::kShare), relaxation.share[i]);
    check.in(branch).number("relaxation.time_s", branch.time_s(), within(limits::kTime_s), relaxation.time_s[i]);
  }
  return relaxation;
}

/// An error states the place of a wrong number, or of the layer if its numbers contradict each other. `before`: the
/// next layer outwards; nullptr: there is none.
tissue::LayerSettings read_tissue_layer(FieldCheck& check, const TissueEffect::Layer& given,
                                        const tissue::LayerSettings* before) {
  tissue::LayerSettings layer{.name = given.name(), .surface = {}, .bulk = {}, .relaxation = {}};
  TELEPALP_READ(check, "layer.", given, top_m, layer.top_m, (within(limits::kTop_m)));
  TELEPALP_READ(check, "layer.", given, thickness_m, layer.thickness_m, (within(limits::kThickness_m)));
  if (given.has_surface()) layer.surface = read_surface(check, given.surface());
  if (given.has_bulk()) layer.bulk = read_bulk(check, given.bulk());
  layer.relaxation = read_relaxation(check, given);
  if (const auto fault = tissue::layer_fault(layer, before))
    check.in(given).complain("layer \"" + layer.name + "\": " + fault->what, fault->fix);
  return layer;
}

tissue::TissueSettings read_tissue_settings(FieldCheck& check, const TissueEffect& given) {
  tissue::TissueSettings settings;
  settings.net_radius_m = 0.06;
  settings.net_edge_m = 0.0075;
  settings.at_m = read_xyz(check, "layered_tissue.at_m", given.at_m(), {-1, 1, "m"});
  const NumberReader read{check, given, "layered_tissue."};
  read(given.has_net_radius_m(), "net_radius_m", given.net_radius_m(), limits::kNetRadius_m, settings.net_radius_m);
  read(given.has_net_edge_m(), "net_edge_m", given.net_edge_m(), limits::kNetEdge_m, settings.net_edge_m);
  read(given.has_spread_m(), "spread_m", given.spread_m(), limits::kSpread_m, settings.net.spread_m);
  read(given.has_subdivisions(), "subdivisions", given.subdivisions(), limits::kSubdivisions,
       settings.net.subdivisions);
  tissue::ShaftSettings& shaft = settings.shaft;
  read(given.has_side_n_per_m(), "side_N_per_m", given.side_n_per_m(), limits::kSide_N_per_m, shaft.side_N_per_m);
  read(given.has_tears_at_n_per_m(), "tears_at_N_per_m", given.tears_at_n_per_m(), limits::kTearsAt_N_per_m,
       shaft.tears_at_N_per_m);
  read(given.has_bevel_rad(), "bevel_rad", given.bevel_rad(), limits::kBevel_rad, shaft.bevel_rad);
  settings.layers.reserve(tissue::TissueSettings::kMostLayers);
  for (const TissueEffect::Layer& layer : given.layer()) {
    if (settings.layers.size() == tissue::TissueSettings::kMostLayers) {
      check.in(layer).complain("the tissue has more than 12 layers", "leave some out");
      break;
    }
    settings.layers.push_back(
        read_tissue_layer(check, layer, settings.layers.empty() ? nullptr : &settings.layers.back()));
  }
  return settings;
}

}  // namespace

effects::LayeredTissueSettings read_layered_tissue(FieldCheck& check, const TissueEffect& given) {
  effects::LayeredTissueSettings recipe;
  recipe.tip_m = read_xyz(check, "layered_tissue.tip_m", given.tip_m(), {-0.3, 0.3, "m"});
  TELEPALP_READ(check, "layered_tissue.", given, skin_left, recipe.skin_left, {0, 1, "N/N"});
  const tissue::TissueSettings settings = read_tissue_settings(check, given);
  if (check.error()) return recipe;
  auto model = tissue::make_tissue(settings);
  if (model)
    recipe.model = std::move(*model);
  else
    check.in(given).complain(model.error().where + ": " + model.error().what, model.error().fix);
  return recipe;
}

}  // namespace telepalp::scenes
