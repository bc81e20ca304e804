#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "proto/words/result.h"
#include "support/nats/nats_address.h"

namespace telepalp::replay {

/// A cell that cannot be made is tried this often, by any workers. Then it is removed from the queue.
inline constexpr std::uint64_t kMostDeliveries = 3;

struct WorkerOptions {
  nats::Address cluster;
  std::string name;             ///< in the sweep's log
  std::filesystem::path cache;  ///< folder of recordings
  std::uint64_t cache_B = 0;    ///< room for recordings in `cache`
  std::size_t memory_B = 0;     ///< room for the images of a sweep's source
  std::chrono::duration<double>
      idle{};  ///< the worker ends when no cell comes for this time; 0: it never ends by itself
};

struct WorkerCounts {
  std::uint64_t finished = 0;    ///< cells
  std::uint64_t given_back = 0;  ///< to other workers
  std::uint64_t refused = 0;     ///< removed as bad
};

/// Makes cells of the sweeps in a cluster, one at a time. When `stop` becomes true, it gives the unfinished cell back
/// to the queue and returns. Error: as SweepCluster::join().
[[nodiscard]] Result<WorkerCounts> run_worker(const WorkerOptions& options, const std::atomic<bool>& stop);

}  // namespace telepalp::replay
