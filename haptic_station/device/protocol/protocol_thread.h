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

/// Runs one io_context on a separate thread, for the protocol of a device or a tracker. Readings go to the haptic
/// thread through a LatestValue. The haptic thread never locks the mutex, which serves the wait for the first answer.
class ProtocolThread {
 public:
  ~ProtocolThread() { stop(); }

  [[nodiscard]] boost::asio::io_context& io() noexcept { return io_; }

  void run() {
    thread_ = std::thread([this] { io_.run(); });
  }
  /// Stops the io_context and joins the thread.
  void stop() {
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }

  /// Called on the thread at each valid answer of the device or tracker; the first one ends wait_for_answer().
  void answered() {
    if (has_answered_.exchange(true)) return;
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }
  /// Called on the thread to store why no valid answer has come yet; the starting thread reports it when its wait times
  /// out.
  void obstacle(std::string what) {
    const std::lock_guard lock(mutex_);
    obstacle_ = std::move(what);
  }

  /// Waits at most `limit` for the first answer; true when it has come.
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
  std::string obstacle_ = "the service sends no valid message";
};

}  // namespace telepalp::device
