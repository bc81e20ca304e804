#pragma once

#include <variant>

#include "haptic_station/effects/fem_prism.h"
#include "haptic_station/effects/friction.h"
#include "haptic_station/effects/inner_cylinder.h"
#include "haptic_station/effects/inner_sphere.h"
#include "haptic_station/effects/layered_tissue.h"
#include "haptic_station/effects/membrane.h"
#include "haptic_station/effects/organ.h"
#include "haptic_station/effects/skin.h"
#include "haptic_station/effects/solid.h"
#include "haptic_station/effects/stiff_regions.h"

namespace telepalp::effects {

/// Every kind of effect. One line here registers a kind: EffectBank then steps it, the core builds it from its recipe,
/// and scenes read it from the field of msg::Effect that has its kName (scenes/read_effects.cpp).
using Effect = std::variant<  //
    Skin,                     //
    InnerCylinder,            //
    InnerSphere,              //
    Friction,                 //
    StiffRegions,             //
    Organ,                    //
    Solid,                    //
    Membrane,                 //
    LayeredTissue,            //
    FemPrism>;

/// The recipes of a list of kinds: one type for each kind, in the same order.
template <class Kinds>
struct RecipesOf;
template <class... Kinds>
struct RecipesOf<std::variant<Kinds...>> {
  using Variant = std::variant<typename Kinds::Settings...>;
};

/// How one effect of a scene is made: plain values, and shapes that were read from files. core::build_effects() makes
/// effects of recipes.
using Recipe = RecipesOf<Effect>::Variant;

}  // namespace telepalp::effects
