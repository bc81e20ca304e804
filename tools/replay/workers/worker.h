#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "support/nats/streams.h"

namespace telepalp::replay {

/// A worker gives a cell that it cannot make back to others, until the cell has been delivered this often.
inline constexpr std::uint64_t kMostDeliveries = 3;

struct WorkerOptions {
  nats::Address cluster;
  std::string name;
  std::filesystem::path cache;
  std::uint64_t cache_B = 0;             ///< of recordings on the disk
  std::size_t memory_B = 0;              ///< for the source of a sweep
  std::chrono::duration<double> idle{};  ///< ends when no cell has come for so long; 0: never
};

struct WorkerCounts {
  std::uint64_t finished = 0;    ///< cells
  std::uint64_t given_back = 0;  ///< to other workers
  std::uint64_t refused = 0;     ///< removed as bad
};

/// Makes cells of sweeps that a cluster offers, one at a time, until `stop` becomes true: then the cell at hand is
/// given back. Error: the cluster cannot be reached, or has no JetStream.
[[nodiscard]] Result<WorkerCounts> run_worker(const WorkerOptions& options, const std::atomic<bool>& stop);

/// The build of this program, on which all of its results depend: "telepalp 0.2.0, commit 1a2b3c4d".
[[nodiscard]] std::string this_build();

/// Makes the streams in which sweeps and workers meet, if the cluster does not have them.
[[nodiscard]] Result<void> keep_streams(nats::Streams& streams);

}  // namespace telepalp::replay
