#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "proto/impaired/profiles.h"
#include "proto/words/numbers/number_row.h"

namespace telepalp::impaired {
namespace {

constexpr std::string_view kHeader = "t_s,delay_ms,jitter_ms,loss_percent,rate_kbit_per_s";
constexpr std::size_t kMostBytes = std::size_t{1} << 20U;
constexpr double kMost = 1e6;  ///< of any figure: eleven days, a quarter of an hour of delay, 1 Gbit/s

using Figures = std::array<double, 5>;

/// The line's five numbers, each from 0 to kMost; nullopt: it does not hold these.
std::optional<Figures> parse_figures(std::string_view line) noexcept {
  const std::optional<Figures> figures = number_row<5>(line);
  const auto is_possible = [](double figure) { return figure >= 0.0 && figure <= kMost; };
  return figures && std::ranges::all_of(*figures, is_possible) ? figures : std::nullopt;
}

TraceRow row_of(const Figures& figures) noexcept {
  return {.at = from_seconds(figures[0]),
          .delay = from_seconds(figures[1] * 1e-3),
          .jitter = from_seconds(figures[2] * 1e-3),
          .loss = figures[3] * 1e-2,
          .rate_B_per_s = figures[4] * 125.0};
}

struct Wrong {
  std::string_view what;
  std::string_view fix;
};

/// Why `row` cannot follow the rows of `trace`; nullopt: it can.
std::optional<Wrong> wrong_with(const Trace& trace, const TraceRow& row) noexcept {
  if (trace.empty() && row.at != Nanoseconds{0})
    return Wrong{"t_s is not 0 in the first row", "write 0 as t_s, the time in seconds, of the first row"};
  if (!trace.empty() && row.at <= trace.back().at)
    return Wrong{"t_s is not larger than in the row before", "sort the rows by t_s, and give each t_s once"};
  if (row.loss > 1.0) return Wrong{"loss_percent is above 100", "give loss_percent from 0 to 100"};
  return std::nullopt;
}

}  // namespace

Result<Trace> parse_trace(std::string_view text, std::string_view where) {
  const auto wrong = [&](std::size_t line, const Wrong& that) {
    return Error{.what = "line " + std::to_string(line) + ": " + std::string(that.what),
                 .where = std::string(where),
                 .fix = std::string(that.fix)};
  };
  if (text.size() > kMostBytes)
    return Error{.what = "the network trace is larger than 1 MiB",
                 .where = std::string(where),
                 .fix = "give a trace with fewer rows"};
  const std::string header = "write as the first line: " + std::string(kHeader);
  const std::string rows = "write rows of " + std::string(kHeader) + ", such as 0,50,5,1,2000";
  if (take_line(text) != kHeader) return wrong(1, {"this is not the header of a network trace", header});
  Trace trace;
  for (std::size_t line = 2; !text.empty(); ++line) {
    const std::optional<Figures> figures = parse_figures(take_line(text));
    if (!figures) return wrong(line, {"the line is not five numbers from 0 to 1000000", rows});
    const TraceRow row = row_of(*figures);
    if (const std::optional<Wrong> that = wrong_with(trace, row)) return wrong(line, *that);
    trace.push_back(row);
  }
  if (trace.size() < 2)
    return Error{.what = "the network trace has fewer than two rows",
                 .where = std::string(where),
                 .fix = "write at least two rows: the trace ends at the t_s of its last row"};
  return trace;
}

Result<Trace> read_trace(const std::filesystem::path& file) {
  std::error_code failed;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, failed))
    return Error{
        .what = "the network trace cannot be read", .where = file.string(), .fix = "name a CSV file that you may read"};
  std::string text(kMostBytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return parse_trace(text, file.string());
}

}  // namespace telepalp::impaired
