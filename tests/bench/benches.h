#pragma once

#include <array>
#include <string_view>

#include "support/program/options.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// One benchmark; it measures and returns its figures.
struct Bench {
  std::string_view name;
  std::string_view purpose;
  Result<Report> (*run)(const program::Arguments& arguments);
};

}  // namespace telepalp::bench
