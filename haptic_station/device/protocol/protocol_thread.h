#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace telepalp::device {

/// One io_context on its own thread, where a device's or a tracker's protocol lives. What it makes goes to the haptic
/// thread by LatestValue. The mutex is for the start alone: whoever starts it waits for the first answer.
class ProtocolThread {
 public:
  ~ProtocolThread() { stop(); }

  [[nodiscard]] boost::asio::io_context& io() noexcept { return io_; }

  void run() {
    thread_ = std::thread([this] { io_.run(); });
  }
  /// Nothing runs on the thread after this.
  void stop() {
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }

  /// On the thread: the other end has answered as it should.
  void answered() {
    if (has_answered_.exchange(true)) return;
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }
  /// On the thread: what is in the way, for whoever waits.
  void obstacle(std::string what) {
    const std::lock_guard lock(mutex_);
    obstacle_ = std::move(what);
  }

  /// True once answered; waits for that at most `limit`.
  [[nodiscard]] bool wait_for_answer(std::chrono::milliseconds limit) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, limit, [this] { return has_answered_.load(); });
  }
  [[nodiscard]] std::string obstacle() {
    const std::lock_guard lock(mutex_);
    return obstacle_;
  }

 private:
  boost::asio::io_context io_{1};
  std::thread thread_;
  std::atomic<bool> has_answered_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string obstacle_;
};

}  // namespace telepalp::device
