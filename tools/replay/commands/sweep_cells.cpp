#include "tools/replay/commands/sweep_cells.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include "support/program/files/whole_file.h"
#include "tools/replay/commands/report.h"
#include "tools/replay/commands/settings.h"

namespace telepalp::replay {
namespace {

std::atomic<bool> stop_asked{false};  // written by the signal handler
static_assert(std::atomic<bool>::is_always_lock_free);

std::filesystem::path file_of(const Request& request, std::size_t cell) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "cells/%03zu.json", cell);
  return request.out / name.data();
}

/// The figures in a cell's report; nullopt: `json` is not a report, or has another identity.
std::optional<Figures> figures_in(const std::string& json, const std::string& identity) {
  google::protobuf::Struct report;
  if (!google::protobuf::util::JsonStringToMessage(json, &report).ok()) return std::nullopt;
  const auto& fields = report.fields();
  const auto named = fields.find("identity"), run = fields.find("run");
  if (named == fields.end() || named->second.string_value() != identity || run == fields.end()) return std::nullopt;
  Figures figures;
  for (const Metric& metric : metrics()) {
    const auto& values = run->second.struct_value().fields();
    const auto value = values.find(std::string(metric.name));
    const bool known = value != values.end() && value->second.has_number_value();
    figures.*metric.value = known ? value->second.number_value() : std::numeric_limits<double>::quiet_NaN();
  }
  return figures;
}

/// The options of the command line that makes one cell alone.
RunOptions options_of(const Request& request, const SweepCell& cell) {
  RunOptions options = request.options;
  for (std::size_t axis = 0; axis < request.axes.size(); ++axis) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.12g%s", cell.values[axis], request.axes[axis].unit == "%" ? "%" : "");
    options[std::string(request.axes[axis].option)] = text.data();
  }
  return options;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

FinishedCells::FinishedCells(const Request& request) : request_(request), figures_(request.cells.size()) {
  if (request.out.empty()) return;
  for (std::size_t i = 0; i < figures_.size(); ++i)
    figures_[i] = figures_in(bytes_of(file_of(request, i)), identity_of(request, request.cells[i].scenario));
  kept_ = count();
}

std::size_t FinishedCells::count() const noexcept {
  return static_cast<std::size_t>(
      std::count_if(figures_.begin(), figures_.end(), [](const auto& one) { return one.has_value(); }));
}

std::vector<std::size_t> FinishedCells::next(std::size_t most) const {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < figures_.size() && cells.size() < most; ++i)
    if (!figures_[i]) cells.push_back(i);
  return cells;
}

Result<void> FinishedCells::add(const std::vector<std::size_t>& batch, const RunResults& results) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    figures_[batch[i]] = results.runs[i + 1].figures;
    RunResults one{.runs = {results.runs.front(), results.runs[i + 1]},
                   .tape_costs = Stopwatch(),
                   .images = results.images,
                   .seconds = results.seconds};
    const Result<void> kept = keep(batch[i], cell_report(request_, request_.cells[batch[i]], one));
    if (!kept) return kept;
  }
  return {};
}

Result<void> FinishedCells::add(std::size_t cell, const std::string& report) {
  const std::optional<Figures> figures = figures_in(report, identity_of(request_, request_.cells[cell].scenario));
  if (!figures)
    return Error{.what = "the report has another identity than its cell",
                 .where = "cell " + std::to_string(cell),
                 .fix = "use workers of the version that this program has"};
  figures_[cell] = *figures;
  return keep(cell, report);
}

Result<void> FinishedCells::keep(std::size_t cell, const std::string& report) const {
  if (request_.out.empty()) return {};
  const Result<void> made = program::make_folder(request_.out / "cells", program::Readers::Group);
  if (!made) return made;
  return program::write_whole_file(file_of(request_, cell), report, program::Readers::Group);
}

std::string cell_report(const Request& request, const SweepCell& cell, const RunResults& results) {
  return report_json(request, cell.scenario, options_of(request, cell), results,
                     judge(request.assertions, results.runs.back().figures));
}

StopOnSignal::StopOnSignal() {
  stop_asked = false;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stop_asked = true; });
}

StopOnSignal::~StopOnSignal() {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

const std::atomic<bool>& StopOnSignal::stopped() noexcept { return stop_asked; }

}  // namespace telepalp::replay
