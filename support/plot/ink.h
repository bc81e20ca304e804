#pragma once

#include <string_view>

namespace telepalp::plot {

inline constexpr std::string_view kInk = "#2b2f36";    ///< of lines and of text
inline constexpr std::string_view kFaint = "#e3e6ea";  ///< of the lines of a grid
inline constexpr double kTextSize = 12.0;              ///< [px]; titles are larger

}  // namespace telepalp::plot
