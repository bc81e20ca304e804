#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/replay/commands/sweep_cells.h"

namespace telepalp::replay {

/// The cells that workers did not finish.
struct SharedOutcome {
  std::vector<std::string> refused{};  ///< for each cell that no worker can make: its place in the grid, and the reason
  std::size_t ordered = 0;             ///< cells that are still in the queue, or with a worker
};

/// Lets workers make the cells of `request` that are not in `finished`, through the cluster `request.workers`. Shows
/// progress and the time left on stderr. Returns when each cell is finished or refused, or when `stop` becomes true:
/// the workers then continue, and the same command takes their results. Error: the cluster cannot be reached, or has no
/// JetStream or no room; the source or scene cannot be sent; or a file of a cell cannot be written.
[[nodiscard]] Result<SharedOutcome> share_sweep(const Request& request, FinishedCells& finished,
                                                const std::atomic<bool>& stop);

}  // namespace telepalp::replay
