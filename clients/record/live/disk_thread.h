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

/// Storage for messages. Both functions are called only on the disk thread and may block.
struct Store {
  std::function<Result<void>(const wire::Message&)> write;
  std::function<Result<void>()> flush;  ///< called within 0.2 s of a write: the data then survive the program's crash
};

/// Takes messages from the network thread and stores them on a separate thread, so that a slow disk never blocks the
/// network. The queue is bounded in bytes; a message without room is dropped and counted by topic. The class uses a
/// mutex and a condition variable, because the disk thread must sleep when idle and neither thread is real-time.
class DiskThread {
 public:
  static constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20;

  explicit DiskThread(Store store, std::size_t max_waiting_bytes = kMaxWaitingBytes);
  ~DiskThread();  // stores the queued messages
  DiskThread(const DiskThread&) = delete;
  DiskThread& operator=(const DiskThread&) = delete;

  /// Queues a message. Network thread only. False: the queue is full, or the store has failed.
  bool offer(const wire::Message& message);

  /// Stores the queued messages without a last flush, and ends the thread. Error: the first error of the store.
  [[nodiscard]] Result<void> finish();

  struct Counts {
    std::uint64_t stored = 0;
    std::uint64_t stored_bytes = 0;  ///< sum of the payloads
    std::uint64_t waiting_bytes = 0;
    std::map<std::string_view, std::uint64_t> dropped;  ///< messages that found the queue full, by topic
    std::optional<Error> failed;
  };
  [[nodiscard]] Counts counts() const;

 private:
  void run();

  Store store_;  // disk thread only
  const std::size_t max_waiting_bytes_;
  mutable std::mutex mutex_;  // guards waiting_, counts_ and finishing_
  std::condition_variable changed_;
  std::deque<wire::Message> waiting_;
  Counts counts_;
  bool finishing_ = false;
  std::thread thread_;  // last member: the thread starts in the constructor and uses the others
};

}  // namespace telepalp::record
