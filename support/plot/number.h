#pragma once

#include <string>

namespace telepalp::plot {

/// `value` with at most `decimals` digits after the point and no trailing zeros; "0" for what rounds to zero, and
/// an en dash for what is not finite. Independent of the locale, unlike printf: a decimal comma would break SVG.
[[nodiscard]] std::string number(double value, int decimals = 2);

/// `value` with about three significant digits, for people: 0.0123, 1.23, 12.3, 1230.
[[nodiscard]] std::string readable(double value);

}  // namespace telepalp::plot
