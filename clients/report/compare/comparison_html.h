#pragma once

#include <string>

#include "clients/report/compare/comparison.h"

namespace telepalp::report {

/// The pictures of both runs at pictured_s() (comparison.h), as PNG; empty: no image of the session can be drawn.
struct PicturePair {
  std::string a;
  std::string b;
};

/// The comparison as one self-contained HTML file without scripts, for screen and print.
[[nodiscard]] std::string comparison_html(const Comparison& comparison, const PicturePair& pictures);

}  // namespace telepalp::report
