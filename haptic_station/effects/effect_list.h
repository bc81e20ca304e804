#pragma once

#include <variant>

#include "haptic_station/effects/friction.h"
#include "haptic_station/effects/inner_cylinder.h"
#include "haptic_station/effects/inner_sphere.h"
#include "haptic_station/effects/membrane.h"
#include "haptic_station/effects/organ.h"
#include "haptic_station/effects/skin.h"
#include "haptic_station/effects/solid.h"
#include "haptic_station/effects/stiff_regions.h"

namespace telepalp::effects {

/// Every kind of effect. A line here registers a kind: EffectBank then steps it, and scenes read it from the field of
/// msg::Effect that has its kName (scenes/read_effects.cpp), with the function read_effect() for its message.
using Effect = std::variant<  //
    Skin,                     //
    InnerCylinder,            //
    InnerSphere,              //
    Friction,                 //
    StiffRegions,             //
    Organ,                    //
    Solid,                    //
    Membrane>;

}  // namespace telepalp::effects
