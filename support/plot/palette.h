#pragma once

#include <string_view>

namespace telepalp::plot {

/// Colours that people with common forms of colour blindness can distinguish.
/// Source: Okabe and Ito, "Color universal design", 2008.
inline constexpr std::string_view kBlack = "#222222";
inline constexpr std::string_view kOrange = "#e69f00";
inline constexpr std::string_view kSky = "#56b4e9";
inline constexpr std::string_view kGreen = "#009e73";
inline constexpr std::string_view kYellow = "#f0e442";
inline constexpr std::string_view kBlue = "#0072b2";
inline constexpr std::string_view kVermilion = "#d55e00";
inline constexpr std::string_view kPurple = "#cc79a7";
inline constexpr std::string_view kGrey = "#8a8f98";

}  // namespace telepalp::plot
