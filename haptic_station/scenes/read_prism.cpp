#include <algorithm>

#include "haptic_station/scenes/number_reader.h"
#include "haptic_station/scenes/read_tissue.h"
#include "haptic_station/tissue/fem/prism_model.h"

namespace telepalp::scenes {
namespace {

using PrismEffect = msg::FemPrismEffect;
namespace limits = tissue::limits;

tissue::PrismSettings read_prism_settings(FieldCheck& check, const PrismEffect& given) {
  tissue::PrismSettings prism;
  prism.name = given.name();
  prism.foot_m = read_xyz(check, "fem_prism.foot_m", given.foot_m(), {-1, 1, "m"});
  if (given.has_size_m())
    prism.grid.size_m = read_xyz(check, "fem_prism.size_m", given.size_m(), within(limits::kSize_m));
  const NumberReader read{check, given, "fem_prism."};
  read(given.has_top_n_per_m(), "top_N_per_m", given.top_n_per_m(), limits::kTop_N_per_m, prism.top_N_per_m);
  read(given.has_poisson(), "poisson", given.poisson(), limits::kPoisson, prism.poisson);
  read(given.has_coupling_n_per_m(), "coupling_N_per_m", given.coupling_n_per_m(), limits::kCoupling_N_per_m,
       prism.coupling_N_per_m);
  read(given.has_spread_m(), "spread_m", given.spread_m(), limits::kPrismSpread_m, prism.spread_m);
  read(given.has_lets_go_n(), "lets_go_N", given.lets_go_n(), limits::kLetsGo_N, prism.lets_go_N);
  read(given.has_across(), "across", given.across(), limits::kAcross, prism.grid.across);
  read(given.has_along(), "along", given.along(), limits::kAlong, prism.grid.along);
  if (given.elements() == PrismEffect::ELEMENTS_LINEAR) prism.grid.order = tissue::ElementOrder::Linear;
  return prism;
}

}  // namespace

effects::FemPrismSettings read_prism(FieldCheck& check, const PrismEffect& given) {
  effects::FemPrismSettings recipe;
  const tissue::PrismSettings prism = read_prism_settings(check, given);
  if (check.error()) return recipe;
  if (prism.coupling_N_per_m > 0.0)  // springs in series are softer than each of them
    recipe.slew.stiffest_N_per_m = std::min(recipe.slew.stiffest_N_per_m, prism.coupling_N_per_m);
  auto model = tissue::make_prism_model(prism);
  if (model)
    recipe.model = std::move(*model);
  else
    check.in(given).complain(model.error().where + ": " + model.error().what, model.error().fix);
  return recipe;
}

}  // namespace telepalp::scenes
