#pragma once

#include "tools/replay/commands/request.h"
#include "tools/replay/words/sweep_axes.h"

namespace telepalp::replay {

/// Runs the source over the network of each cell (a combination of the axes' values), on `request.threads` threads;
/// prints the table, and writes sweep.txt, sweep.csv, sweep.json, heat maps (two axes or more) and cells/NNN.json to
/// --out. Cells that an earlier run of the same command has finished are not made again. SIGINT and SIGTERM end the
/// sweep and keep the finished cells. True: all cells are finished, and the assertions hold in every cell.
[[nodiscard]] Result<bool> run_sweep(const Request& request);

}  // namespace telepalp::replay
