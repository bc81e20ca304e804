#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/images/lettering.h"

namespace telepalp::ar {

/// One line of a panel: a name with its value, or, with a `swatch`, the legend of a colour in the picture.
struct PanelLine {
  std::string name;
  std::string value;
  std::optional<images::Ink> swatch = std::nullopt;
};

enum class Corner { TopLeft, TopRight, BottomLeft, BottomRight };

/// Draws a dark translucent panel with rounded corners in a corner of the image, names to the left and values to the
/// right. Draws nothing when `lines` is empty.
void draw_panel(ColorImage& image, Corner corner, const std::vector<PanelLine>& lines);

}  // namespace telepalp::ar
