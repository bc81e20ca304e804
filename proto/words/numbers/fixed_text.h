#pragma once

#include <cstdio>
#include <string>

namespace telepalp {

/// `value` with this number of decimals: "8.24". For tables and sentences; data files use number_text().
[[nodiscard]] inline std::string fixed_text(double value, int decimals = 1) {
  char text[400];  // the largest double has 309 digits before the point
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

}  // namespace telepalp
