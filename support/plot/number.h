#pragma once

#include <string>

namespace telepalp::plot {

/// Formats `value` with at most `decimals` decimals and without trailing zeros: "0" if it rounds to zero, an en dash if
/// it is not finite. The decimal point does not depend on the locale, unlike printf's; a comma would break SVG.
[[nodiscard]] std::string number(double value, int decimals = 2);

/// Formats `value` with three significant digits, or with all digits before the point: 0.0123, 1.23, 12.3, 1234.
[[nodiscard]] std::string readable(double value);

}  // namespace telepalp::plot
