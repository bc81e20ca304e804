#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>

#include "tools/replay/workers/cell_order.h"

namespace telepalp::replay {

/// Makes the cells that orders describe. The source and the unimpaired run of the last sweep stay in memory, so that
/// another cell of this sweep costs one run only. Owner: one thread.
class CellMaker {
 public:
  /// `scratch`: a folder for the scene's file. `most_B`: memory for a source and its unimpaired run; a source that
  /// needs more is read again for each cell.
  CellMaker(std::filesystem::path scratch, std::size_t most_B);
  ~CellMaker();
  CellMaker(const CellMaker&) = delete;
  CellMaker& operator=(const CellMaker&) = delete;

  /// The text of the cell's report, cell_report() in sweep_cells.h. `source`: the local file of the recording, or the
  /// name of the synthetic source. Error: the settings are wrong, the scene names a file and is not of telepalp's
  /// library, the source cannot be read, the cell has another identity than the order states, or `stop` became true.
  [[nodiscard]] Result<std::string> make(const CellOrder& order, const std::string& source,
                                         const std::atomic<bool>& stop);

 private:
  struct Kept;
  [[nodiscard]] Result<std::filesystem::path> scene_file_of(const CellOrder& order) const;
  [[nodiscard]] Result<std::unique_ptr<Kept>> prepare(const CellOrder& order, const std::string& source,
                                                      const std::atomic<bool>& stop) const;

  std::filesystem::path scratch_;
  std::size_t most_B_;
  std::unique_ptr<Kept> kept_;  // of the last sweep; nullptr: no cell was made, or the last sweep cannot be prepared
};

/// The file of the scene `name` in telepalp's library, if its content is `text`; otherwise nullopt.
[[nodiscard]] std::optional<std::filesystem::path> scene_of_library(const std::string& name, const std::string& text);

/// `order` without CellOrder::cell and at, so that the orders of one sweep are equal.
[[nodiscard]] CellOrder sweep_of(CellOrder order);

}  // namespace telepalp::replay
