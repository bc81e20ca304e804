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

/// Stores the chunks that are missing in the cluster, until `stop` becomes true. `progress`: called with the bytes that
/// the cluster has. Error: the cluster has no room for a chunk, or the file has become shorter.
[[nodiscard]] Result<void> store_recording(nats::Streams& streams, const LocalRecording& recording,
                                           const std::atomic<bool>& stop,
                                           const std::function<void(std::uint64_t bytes)>& progress);

/// A folder of recordings that were fetched from the cluster; each file's name is the SHA-256 of its content. Several
/// programs may share the folder. Owner: one thread.
class RecordingCache {
 public:
  /// `most_B`: size of all recordings together. To make room, the least recently used ones are removed.
  RecordingCache(std::filesystem::path folder, std::uint64_t most_B) : folder_(std::move(folder)), most_B_(most_B) {}

  /// The file of `recording`, fetched if the folder does not have it. Its digest is checked when it is fetched, and
  /// when this object uses it first. Error: the cluster lacks a chunk, a chunk has another size, the digest is wrong,
  /// the recording is larger than the cache, the disk is full, or `stop` became true.
  [[nodiscard]] Result<std::filesystem::path> fetch(nats::Streams& streams, const Recording& recording,
                                                    const std::atomic<bool>& stop);

 private:
  [[nodiscard]] Result<void> make_room(std::uint64_t bytes) const;
  [[nodiscard]] Result<void> write_chunks(nats::Streams& streams, const Recording& recording,
                                          const std::filesystem::path& file, const std::atomic<bool>& stop) const;

  std::filesystem::path folder_;
  std::uint64_t most_B_;
  std::string checked_;  // SHA-256 of the recording that was checked last
};

}  // namespace telepalp::replay
