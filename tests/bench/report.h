#pragma once

#include <optional>
#include <string>
#include <vector>

namespace telepalp::bench {

/// The kind of a figure's requirement.
enum class Bound { None, AtMost, AtLeast };

/// One figure with its name and its requirement.
struct Row {
  std::string name;
  double value = 0.0;
  std::string unit;
  Bound bound = Bound::None;
  double reach = 0.0;

  [[nodiscard]] bool holds() const noexcept;
};

/// Results of one benchmark.
struct Report {
  std::string bench;
  std::vector<Row> rows;
  std::vector<std::string> notes;  ///< conditions, for the table's foot

  [[nodiscard]] bool holds() const noexcept;
};

[[nodiscard]] Row measured(std::string name, double value, std::string unit);
[[nodiscard]] Row at_most(std::string name, double value, std::string unit, double reach);
[[nodiscard]] Row at_least(std::string name, double value, std::string unit, double reach);

/// {"bench","commit","machine","rows":[{"name","value","unit","reach","holds"}]}; a figure that is not finite is null
/// and does not hold; `reach` is null without a requirement.
[[nodiscard]] std::string to_json(const Report& report);
[[nodiscard]] std::string to_table(const Report& report);

/// The processor and its number of cores.
[[nodiscard]] std::string machine_name();

}  // namespace telepalp::bench
