#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include "proto/wire/message.h"
#include "proto/words/result.h"

namespace telepalp::record {

/// Where messages end up; called on the disk thread only, and allowed to be slow.
struct Store {
  std::function<Result<void>(const wire::Message&)> write;
  std::function<Result<void>()> flush;  ///< when nothing came for a second: what was written shall survive a crash
};

/// Takes messages from the network thread and stores them on a thread of its own, so that a slow disk never stalls
/// the link. What waits is bounded in bytes; a message for which there is no room is dropped and counted by topic.
/// A mutex, since the disk thread must sleep while there is nothing to do and neither thread is a real-time one.
class DiskThread {
 public:
  static constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20;

  explicit DiskThread(Store store, std::size_t max_waiting_bytes = kMaxWaitingBytes);
  ~DiskThread();  // stores what waits
  DiskThread(const DiskThread&) = delete;
  DiskThread& operator=(const DiskThread&) = delete;

  /// Network thread. False: no room, or the store has failed.
  bool offer(const wire::Message& message);

  /// Stores what waits and ends the thread. The first error of the store, if there was one.
  [[nodiscard]] Result<void> finish();

  struct Counts {
    std::uint64_t stored = 0;
    std::uint64_t stored_bytes = 0;  ///< payloads
    std::uint64_t waiting_bytes = 0;
    std::map<std::string_view, std::uint64_t> dropped;
    std::optional<Error> failed;
  };
  [[nodiscard]] Counts counts() const;

 private:
  void run();

  Store store_;  // disk thread only
  const std::size_t max_waiting_bytes_;
  mutable std::mutex mutex_;  // guards all below
  std::condition_variable changed_;
  std::deque<wire::Message> waiting_;
  Counts counts_;
  bool finishing_ = false;
  std::thread thread_;  // last: runs as soon as it is made
};

}  // namespace telepalp::record
