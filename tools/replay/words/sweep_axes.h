#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {

/// One parameter of the scenario and its values in a sweep.
struct SweepAxis {
  std::string_view name;    ///< "delay"
  std::string_view unit;    ///< "ms"; "%" for shares
  std::string_view option;  ///< that sets it for a single run: "delay-ms"
  std::vector<double> values;
  void (*set)(Scenario& scenario, double value);
};

/// One cell of a sweep: a value on each axis.
struct SweepCell {
  std::vector<double> values;
  Scenario scenario;
};

/// Parses "delay=0:50:300" (from, step, to) and "loss=0,1,5,10%" (a list). The axes are delay and jitter [ms], loss and
/// reorder [%], burst [packets], rate [kbit/s] and seed. Error: an unknown or repeated axis, not a list
/// of numbers, a value out of the axis's range, or more than 1000 values on an axis.
[[nodiscard]] Result<std::vector<SweepAxis>> parse_axes(const std::vector<std::string>& words);

/// Every combination of the axes' values; the last axis varies fastest. All else is as in `base`. If
/// `deadline_follows`, each cell has the deadline usual_deadline(). Error: more than 4096 cells.
[[nodiscard]] Result<std::vector<SweepCell>> sweep_cells(const std::vector<SweepAxis>& axes, const Scenario& base,
                                                         bool deadline_follows);

}  // namespace telepalp::replay
