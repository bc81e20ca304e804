#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>

#include "haptic_station/core/journal/journal_file.h"
#include "haptic_station/core/journal/journal_tick.h"
#include "proto/words/result.h"
#include "proto/words/spsc_ring.h"

namespace telepalp::station {

/// The thread that writes a station's journal. No other thread waits for it: the haptic thread hands over ticks by a
/// ring of 8 s, the stages' threads post their runs, of which at most 256 MiB wait. What does not fit is counted, and
/// marks the journal as incomplete.
class JournalThread {
 public:
  /// Creates `file`, readable for its group, encrypted if TELEPALP_SITE_KEYS names a key. Error: it cannot be written,
  /// or the key cannot be read.
  [[nodiscard]] static Result<std::unique_ptr<JournalThread>> open(const std::filesystem::path& file,
                                                                   const msg::JournalHeader& header);
  ~JournalThread();
  JournalThread(const JournalThread&) = delete;
  JournalThread& operator=(const JournalThread&) = delete;

  /// Haptic thread only. Does not allocate, lock or call the system.
  void add(const core::JournalTick& tick) noexcept {
    if (!ticks_->try_push(tick)) ticks_lost_.fetch_add(1, std::memory_order_relaxed);
  }
  /// Threads of the stages.
  void add(msg::JournalSurfaceRun run);
  void add(msg::JournalCollisionRun run);

  /// Writes what is left and the end. Call it when the other threads have ended. Error: the disk is full or failed.
  [[nodiscard]] Result<void> close();
  /// After close(): what the journal holds, and what it lacks.
  [[nodiscard]] const msg::JournalEnd& end() const noexcept { return end_; }

 private:
  using Ring = SpscRing<core::JournalTick, 16384>;

  JournalThread(const std::filesystem::path& file, std::unique_ptr<std::ostream> out, const msg::JournalHeader& header);
  void add(msg::JournalBlock block);
  void every_20_ms();
  void drain();

  std::filesystem::path file_;
  std::unique_ptr<Ring> ticks_ = std::make_unique<Ring>();  // haptic thread to this thread
  std::atomic<std::uint64_t> ticks_lost_{0};
  std::atomic<std::uint64_t> runs_lost_{0};
  std::atomic<std::size_t> waiting_bytes_{0};  // of the runs that were posted and not written
  std::unique_ptr<std::ostream> out_;          // this and the following members, owner: this thread; then close()
  core::JournalWriter writer_;
  msg::JournalEnd end_;
  bool closing_ = false;  // a timer that has expired cannot be cancelled
  boost::asio::io_context io_{1};
  boost::asio::steady_timer timer_{io_};
  std::thread thread_;
};

}  // namespace telepalp::station
