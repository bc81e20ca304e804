#pragma once

#include <string>

#include "tools/study/task/design.h"

namespace telepalp::study {

/// The mechanism as an SVG element, as it stands when the tip touches the sac: link 3 at a right angle to link 4. What
/// the mechanism does not give is drawn with the middle of its range (plant_ranges()). The patient is below. All
/// drawings have one scale, so they can be compared. Empty: the links cannot close there.
[[nodiscard]] std::string linkage_drawing(const Configuration& mechanism, const std::string& title);

}  // namespace telepalp::study
