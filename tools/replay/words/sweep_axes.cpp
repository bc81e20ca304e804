#include "tools/replay/words/sweep_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "proto/words/number_word.h"
#include "tools/replay/words/network_options.h"
#include "tools/replay/words/words.h"

namespace telepalp::replay {
namespace {

using impaired::Impairment;

constexpr std::size_t kMostValues = 1000;
constexpr std::size_t kMostCells = 4096;

template <class Set>
void both(Scenario& scenario, Set set) {
  set(scenario.down);
  set(scenario.up);
}

struct Axis {
  std::string_view name;
  std::string_view unit;
  std::string_view option;
  double most;
  void (*set)(Scenario& scenario, double value);
};
constexpr auto kAxes = std::to_array<Axis>({
    {"delay", "ms", "delay-ms", 60e3,
     [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.delay = from_milliseconds(v); }); }},
    {"jitter", "ms", "jitter-ms", 60e3,
     [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.jitter = from_milliseconds(v); }); }},
    {"loss", "%", "loss", 100.0, [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.loss = v / 100.0; }); }},
    {"reorder", "%", "reorder", 100.0,
     [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.reorder = v / 100.0; }); }},
    {"burst", "packets", "burst", 1e4,
     [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.burst_packets = v; }); }},
    {"rate", "kbit/s", "rate-kbps", 1e8,
     [](Scenario& s, double v) { both(s, [v](Impairment& i) { i.rate_B_per_s = v * 125.0; }); }},
    {"seed", "", "seed", 1e15, [](Scenario& s, double v) { s.seed = static_cast<std::uint64_t>(v); }},
});

std::string axis_names() {
  std::string names;
  for (const Axis& axis : kAxes) names += (names.empty() ? "" : ", ") + std::string(axis.name);
  return names;
}

Error refused(std::string_view word, const std::string& what) {
  return {.what = "'" + std::string(word) + "' " + what,
          .where = "--sweep",
          .fix = "give AXIS=FROM:STEP:TO or AXIS=A,B,C, such as delay=0:50:300 loss=0,1,5,10%; the axes are " +
                 axis_names()};
}

/// The numbers in `text`, which `separator` divides; nullopt if one of the parts is not a number.
std::optional<std::vector<double>> numbers(std::string_view text, char separator) {
  std::vector<double> values;
  for (std::string_view rest = text; values.size() <= kMostValues;) {
    const std::size_t end = rest.find(separator);
    const std::optional<double> value = finite_number_of(rest.substr(0, end));
    if (!value) return std::nullopt;
    values.push_back(*value);
    if (end == std::string_view::npos) return values;
    rest = rest.substr(end + 1);
  }
  return std::nullopt;
}

std::optional<std::vector<double>> range(std::string_view text) {
  const auto parts = numbers(text, ':');
  if (!parts || parts->size() != 3) return std::nullopt;
  const double from = (*parts)[0], step = (*parts)[1], to = (*parts)[2];
  if (!(step > 0.0) || to < from || (to - from) / step > static_cast<double>(kMostValues)) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 0; from + static_cast<double>(i) * step <= to + 1e-9 * step; ++i)
    values.push_back(from + static_cast<double>(i) * step);
  return values;
}

Result<SweepAxis> parse_axis(std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos) return refused(word, "is not AXIS=VALUES");
  const std::string_view name = word.substr(0, equals);
  const auto axis = std::find_if(kAxes.begin(), kAxes.end(), [&](const Axis& one) { return one.name == name; });
  if (axis == kAxes.end()) return refused(word, "names an unknown axis");
  std::string_view text = word.substr(equals + 1);
  if (axis->unit == "%" && text.ends_with('%')) text.remove_suffix(1);
  const auto values = text.find(':') != std::string_view::npos ? range(text) : numbers(text, ',');
  if (!values || values->size() > kMostValues)
    return refused(word, "does not give 1 to 1000 numbers, or STEP is not above 0, or TO is below FROM");
  if (std::any_of(values->begin(), values->end(), [&](double value) { return value < 0.0 || value > axis->most; }))
    return refused(word,
                   "has a value out of range: delay and jitter take 0 to 60000 ms, loss and reorder 0 to 100 %, "
                   "burst 0 to 10000 packets, rate 0 to 1e8 kbit/s, seed 0 to 1e15");
  return SweepAxis{.name = axis->name, .unit = axis->unit, .option = axis->option, .values = *values, .set = axis->set};
}

}  // namespace

Result<std::vector<SweepAxis>> parse_axes(const std::vector<std::string>& words) {
  std::vector<SweepAxis> axes;
  for (const std::string& word : words) {
    Result<SweepAxis> axis = parse_axis(word);
    if (!axis) return axis.error();
    if (std::any_of(axes.begin(), axes.end(), [&](const SweepAxis& other) { return other.name == axis->name; }))
      return refused(word, "names an axis that --sweep names already");
    axes.push_back(std::move(*axis));
  }
  return axes;
}

Result<std::vector<SweepCell>> sweep_cells(const std::vector<SweepAxis>& axes, const Scenario& base,
                                           bool deadline_follows) {
  std::vector<SweepCell> cells{{.values = {}, .scenario = base}};
  for (const SweepAxis& axis : axes) {
    if (cells.size() * axis.values.size() > kMostCells)
      return Error{.what = "the axes have more than 4096 combinations of values",
                   .where = "--sweep",
                   .fix = "give fewer values"};
    std::vector<SweepCell> more;
    for (const SweepCell& cell : cells)
      for (const double value : axis.values) {
        more.push_back(cell);
        more.back().values.push_back(value);
        axis.set(more.back().scenario, value);
      }
    cells = std::move(more);
  }
  if (deadline_follows)
    for (SweepCell& cell : cells) cell.scenario.deadline = usual_deadline(cell.scenario.down);
  return cells;
}

}  // namespace telepalp::replay
