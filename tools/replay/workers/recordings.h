#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "support/nats/streams.h"
#include "tools/replay/workers/cell_order.h"

namespace telepalp::replay {

/// A recording on this computer.
struct LocalRecording {
  std::filesystem::path file;
  Recording content;
};

/// The recording that `source` names, in chunks of at most `most_chunk_B`; nullopt: a synthetic patient. Error: a
/// source that cannot be sent to workers, such as a folder of images, or a file that cannot be read.
[[nodiscard]] Result<std::optional<LocalRecording>> local_recording(const std::string& source,
                                                                    std::uint64_t most_chunk_B);

/// Removes the recording's chunks from the cluster, because they may be damaged.
[[nodiscard]] Result<void> forget_recording(nats::Streams& streams, const Recording& recording);

/// Stores the chunks that the cluster does not hold yet. `progress`: called with the bytes done. Error: the cluster has
/// no room for a chunk, or the file has become shorter. When `stop` becomes true, some chunks are missing.
[[nodiscard]] Result<void> store_recording(nats::Streams& streams, const LocalRecording& recording,
                                           const std::atomic<bool>& stop,
                                           const std::function<void(std::uint64_t bytes)>& progress);

/// Recordings from the cluster, in files of a folder that are named by their digest alone. Several programs may share
/// the folder. Owner: one thread.
class RecordingCache {
 public:
  /// `most_B`: of all recordings together. The one that was used longest ago is removed to make room.
  RecordingCache(std::filesystem::path folder, std::uint64_t most_B) : folder_(std::move(folder)), most_B_(most_B) {}

  /// The file of `recording`. It is fetched if the folder does not have it, and its digest is checked in either case.
  /// Error: the cluster lacks a chunk, a chunk has another size, the digest is wrong, the recording is larger than the
  /// cache, or the disk is full.
  [[nodiscard]] Result<std::filesystem::path> fetch(nats::Streams& streams, const Recording& recording,
                                                    const std::atomic<bool>& stop);

 private:
  [[nodiscard]] Result<void> make_room(std::uint64_t bytes) const;
  [[nodiscard]] Result<void> write_chunks(nats::Streams& streams, const Recording& recording,
                                          const std::filesystem::path& file, const std::atomic<bool>& stop) const;

  std::filesystem::path folder_;
  std::uint64_t most_B_;
  std::string checked_;  // digest of the recording that was checked last
};

}  // namespace telepalp::replay
