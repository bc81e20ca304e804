#pragma once

#include "haptic_station/tissue/net/stiffness_map.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// Upper bound of the force on a needle in `settings` [N]: the greatest sum of the forces of all nets that one tip can
/// push at once, the friction of all holes, the forces at which all layers slip and are cut, and the sideways force of
/// the hole on the shaft. `range`: of the net's stiffness over the places of contact.
[[nodiscard]] double most_force_N(const TissueSettings& settings, const StiffnessRange& range) noexcept;

}  // namespace telepalp::tissue
