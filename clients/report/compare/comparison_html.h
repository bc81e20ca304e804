#pragma once

#include <string>

#include "clients/report/compare/comparison.h"

namespace telepalp::report {

/// The pictures of both runs at one time, as PNG; empty: the session has no images.
struct PicturePair {
  std::string a;
  std::string b;
};

/// The comparison as one self-contained HTML file without scripts, for screen and print.
[[nodiscard]] std::string comparison_html(const Comparison& comparison, const PicturePair& pictures);

}  // namespace telepalp::report
