#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "tools/replay/commands/request.h"

namespace telepalp::replay {

/// The cells of a sweep that are finished. With --out, each finished cell is a file cells/NNN.json, which a later run
/// of the same command reads instead of making the cell again.
class FinishedCells {
 public:
  /// Reads the finished cells from --out. A file counts if its identity (identity_of(), settings.h) is the cell's.
  explicit FinishedCells(const Request& request);

  [[nodiscard]] std::size_t count() const noexcept;
  [[nodiscard]] std::size_t kept() const noexcept { return kept_; }  ///< read from files
  /// Indices of at most `most` cells that are not finished.
  [[nodiscard]] std::vector<std::size_t> next(std::size_t most) const;
  /// The figures of a cell; nullopt: not finished.
  [[nodiscard]] const std::vector<std::optional<Figures>>& figures() const noexcept { return figures_; }

  /// Adds the cells `batch`. `results`: the unimpaired run, then the run of each of these cells. Error: a file cannot
  /// be written.
  [[nodiscard]] Result<void> add(const std::vector<std::size_t>& batch, const RunResults& results);

  /// Adds a cell that somebody else has made. `report`: cell_report(). Error: the report is not of this cell, or its
  /// file cannot be written.
  [[nodiscard]] Result<void> add(std::size_t cell, const std::string& report);

 private:
  [[nodiscard]] Result<void> keep(std::size_t cell, const std::string& report) const;

  const Request& request_;
  std::vector<std::optional<Figures>> figures_;
  std::size_t kept_ = 0;
};

/// The text of a cell's file, cells/NNN.json. `results`: the unimpaired run, then the cell's.
[[nodiscard]] std::string cell_report(const Request& request, const SweepCell& cell, const RunResults& results);

/// While it lives, SIGINT and SIGTERM only set stopped().
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  [[nodiscard]] static const std::atomic<bool>& stopped() noexcept;
};

}  // namespace telepalp::replay
