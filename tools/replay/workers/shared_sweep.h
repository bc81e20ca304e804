#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "tools/replay/commands/sweep_cells.h"

namespace telepalp::replay {

/// What workers did with a sweep.
struct SharedOutcome {
  std::vector<std::string> refused{};  ///< a line for each cell that no worker can make
  std::size_t ordered = 0;             ///< cells that are still in the queue, or with a worker
};

/// Lets workers make the cells of `request` that are not in `finished`, by the cluster that `request.workers` names.
/// Shows progress and the time left on stderr. Returns when each cell is finished or refused, or when `stop` becomes
/// true: the workers then go on, and the same command takes their results. Error: the cluster cannot be reached, has no
/// JetStream or no room; the source or scene cannot be sent; or a file of a cell cannot be written.
[[nodiscard]] Result<SharedOutcome> share_sweep(const Request& request, FinishedCells& finished,
                                                const std::atomic<bool>& stop);

}  // namespace telepalp::replay
