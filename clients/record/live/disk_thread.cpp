#include "clients/record/live/disk_thread.h"

#include <utility>

namespace telepalp::record {
namespace {

constexpr auto kFlushEvery = std::chrono::milliseconds(200);

/// Approximate memory of a queued message; an empty one takes memory, too.
std::size_t weight(const wire::Message& message) { return message.payload->size() + 128; }

}  // namespace

DiskThread::DiskThread(Store store, std::size_t max_waiting_bytes)
    : store_(std::move(store)), max_waiting_bytes_(max_waiting_bytes), thread_([this] { run(); }) {}

DiskThread::~DiskThread() { (void)finish(); }

bool DiskThread::offer(const wire::Message& message) {
  {
    const std::scoped_lock lock(mutex_);
    if (counts_.failed) return false;
    if (counts_.waiting_bytes + weight(message) > max_waiting_bytes_) {
      ++counts_.dropped[message.topic.name];
      return false;
    }
    counts_.waiting_bytes += weight(message);
    waiting_.push_back(message);
  }
  changed_.notify_one();
  return true;
}

Result<void> DiskThread::finish() {
  {
    const std::scoped_lock lock(mutex_);
    finishing_ = true;
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
  if (counts_.failed) return *counts_.failed;
  return {};
}

DiskThread::Counts DiskThread::counts() const {
  const std::scoped_lock lock(mutex_);
  return counts_;
}

void DiskThread::run() {
  using Clock = std::chrono::steady_clock;
  std::unique_lock lock(mutex_);
  auto flushed_at = Clock::now();
  for (bool has_unflushed = false;;) {
    changed_.wait_for(lock, kFlushEvery, [&] { return finishing_ || !waiting_.empty(); });
    if (finishing_ && waiting_.empty()) return;
    const std::deque<wire::Message> taken = std::exchange(waiting_, {});
    const bool is_due = Clock::now() - flushed_at >= kFlushEvery && (has_unflushed || !taken.empty());
    if (taken.empty() && !is_due) continue;
    lock.unlock();
    Result<void> done;
    std::size_t bytes = 0;
    std::size_t stored = 0;
    for (const wire::Message& message : taken) {
      done = store_.write(message);
      if (!done) break;
      bytes += message.payload->size();
      ++stored;
    }
    if (done && is_due) {
      done = store_.flush();
      flushed_at = Clock::now();
    }
    has_unflushed = !is_due;
    lock.lock();
    counts_.stored += stored;
    counts_.stored_bytes += bytes;
    counts_.waiting_bytes = 0;
    for (const wire::Message& message : waiting_) counts_.waiting_bytes += weight(message);
    if (!done) {
      counts_.failed = done.error();
      waiting_.clear();
      return;
    }
  }
}

}  // namespace telepalp::record
