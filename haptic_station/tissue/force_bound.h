#pragma once

#include <span>

#include "haptic_station/tissue/net/stiffness_map.h"
#include "haptic_station/tissue/tissue_settings.h"

namespace telepalp::tissue {

/// The greatest sum of the forces of all nets that one tip can push at once [N]. The tip pushes an outer net until it
/// is punctured, and with it each net that lies less deep below it than this net bends; a net below it is not punctured
/// before. Where the tip comes from inside, each net is punctured by its own force.
///
/// Bound: a net that has relaxed bends further before it is punctured, so its depth is that of the relaxed net, and the
/// force of the others is that of nets that have not relaxed.
[[nodiscard]] double pushed_at_once_N(std::span<const LayerSettings> layers, const StiffnessRange& range) noexcept;

/// Greatest force of a needle in `settings` [N]: pushed_at_once_N(), the friction of all holes, the forces at which all
/// layers slip and are cut, and the sideways force of the hole on the shaft.
[[nodiscard]] double most_force_N(const TissueSettings& settings, const StiffnessRange& range) noexcept;

}  // namespace telepalp::tissue
