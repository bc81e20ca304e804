#include "support/plot/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace telepalp::plot {

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  std::array<char, 400> text{};  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
  std::string out(text.data(), end);
  if (out.find('.') != std::string::npos) {
    out.erase(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
  }
  return out == "-0" ? "0" : out;
}

std::string readable(double value) {
  if (!std::isfinite(value) || value == 0.0) return number(value);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return number(value, std::clamp(2 - magnitude, 0, 9));
}

}  // namespace telepalp::plot
