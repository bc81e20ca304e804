#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::report {

struct Comparison;

/// One way in which two runs may differ, and by how much they may.
struct Tolerance {
  std::string_view name;  ///< ends with the unit: "force_rms_N"
  std::string_view unit;
  std::string_view what;  ///< what differs, for people
  double at_most = 0.0;
};

/// All tolerances with their defaults.
[[nodiscard]] std::span<const Tolerance> default_tolerances() noexcept;

/// The names and defaults as they are written on a command line: "force_rms_N<=0.1, …".
[[nodiscard]] std::string default_tolerances_in_words();

/// The defaults, in which `text`, a list with commas, replaces values: "force_rms_N<=0.3,latency_ms<=60". "same"
/// replaces nothing. Error: an unknown name, or a value that is not a number of at least 0.
[[nodiscard]] Result<std::vector<Tolerance>> parse_tolerances(std::string_view text, std::string_view option);

/// The outcome of one tolerance.
struct Difference {
  Tolerance tolerance;
  double value = 0.0;    ///< infinite: one run alone has the figure; NaN (kUnknown): neither has
  std::string detail{};  ///< the figures of both runs, for people; may be empty
  [[nodiscard]] bool holds() const noexcept;
};

/// The comparison's differences, one for each of `tolerances`, in their order.
[[nodiscard]] std::vector<Difference> differences_of(const Comparison& comparison,
                                                     const std::vector<Tolerance>& tolerances);

}  // namespace telepalp::report
