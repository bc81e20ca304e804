#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "tools/replay/workers/cell_order.h"

namespace telepalp::replay {

/// Makes the cells that orders describe. It keeps the source and the unimpaired run of the last sweep in memory, so
/// that each further cell of this sweep costs its own run alone. Owner: one thread.
class CellMaker {
 public:
  /// `scratch`: a folder for the scene's file. `most_B`: memory for a source and its unimpaired run; a source that
  /// needs more is read again for each cell.
  CellMaker(std::filesystem::path scratch, std::size_t most_B);
  ~CellMaker();
  CellMaker(const CellMaker&) = delete;
  CellMaker& operator=(const CellMaker&) = delete;

  /// The text of the cell's report, cell_report() in sweep_cells.h. `source`: the local file of the recording, or the
  /// name of the synthetic source. Error: the settings are wrong, the scene names a file that is not telepalp's own,
  /// the source cannot be read, the cell has another identity than the order states, or `stop` became true.
  [[nodiscard]] Result<std::string> make(const CellOrder& order, const std::string& source,
                                         const std::atomic<bool>& stop);

 private:
  struct Kept;
  [[nodiscard]] Result<std::filesystem::path> scene_file_of(const CellOrder& order) const;
  [[nodiscard]] Result<std::unique_ptr<Kept>> prepare(const CellOrder& order, const std::string& source,
                                                      const std::atomic<bool>& stop) const;

  std::filesystem::path scratch_;
  std::size_t most_B_;
  std::unique_ptr<Kept> kept_;  // of the last sweep; nullptr: none yet
};

/// The file of telepalp's scene library that `order` names, if it has the order's text; nullopt: none.
[[nodiscard]] std::optional<std::filesystem::path> scene_of_library(const std::string& name, const std::string& text);

/// What the order of a cell says, without the cell: all but CellOrder::cell and at.
[[nodiscard]] CellOrder sweep_of(CellOrder order);

}  // namespace telepalp::replay
