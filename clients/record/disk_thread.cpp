#include "clients/record/disk_thread.h"

#include <utility>

namespace telepalp::record {
namespace {

constexpr auto kFlushAfter = std::chrono::seconds(1);

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
  std::unique_lock lock(mutex_);
  for (bool flushed = true;;) {
    changed_.wait_for(lock, kFlushAfter, [&] { return finishing_ || !waiting_.empty(); });
    if (finishing_ && waiting_.empty()) return;
    const std::deque<wire::Message> taken = std::exchange(waiting_, {});
    if (taken.empty() && flushed) continue;
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
    if (taken.empty()) done = store_.flush();
    flushed = taken.empty();
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
