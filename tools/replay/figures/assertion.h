#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tools/replay/figures/metrics.h"

namespace telepalp::replay {

enum class Comparison { Less, AtMost, More, AtLeast };

/// A limit that a user sets for one metric: "force_rmse_N<0.05".
struct Assertion {
  const Metric* metric = nullptr;
  Comparison comparison = Comparison::Less;
  double limit = 0.0;
  std::string text;  ///< as it was written
};

/// Parses METRIC<NUMBER, with <, <=, > or >=, separated by commas. Error: an unknown metric, reported with the nearest
/// name, a missing comparison, or a limit that is not a finite number.
[[nodiscard]] Result<std::vector<Assertion>> parse_assertions(std::string_view text);

/// The outcome of one assertion.
struct Judgement {
  std::string text;
  bool holds = false;
  std::string reason;  ///< why it fails: "force_rmse_N is 0.07"; empty if it holds
};
/// An assertion fails if its metric is NaN.
[[nodiscard]] std::vector<Judgement> judge(const std::vector<Assertion>& assertions, const Figures& figures);

}  // namespace telepalp::replay
