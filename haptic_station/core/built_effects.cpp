#include "haptic_station/core/built_effects.h"

namespace telepalp::core {

BuiltEffects build_effects(std::span<const effects::Recipe> recipes) { return build_kinds<effects::Effect>(recipes); }

}  // namespace telepalp::core
