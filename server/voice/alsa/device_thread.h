#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "proto/words/result.h"

namespace telepalp::voice {

/// A thread that uses a device while the device is wanted, and tries again when the device is not there or has been
/// taken away. The mutex and the condition variable are there because it must sleep until it is wanted.
class DeviceThread {
 public:
  struct Work {
    /// Uses the device until goes_on() is false. Error: why it cannot; it is called again after kRetry.
    std::function<Result<void>(DeviceThread& thread)> use;
    /// `problem`: why the device cannot be used; empty: it can, or it is no longer wanted. Called on this thread when
    /// the problem is another one.
    std::function<void(const std::string& problem)> on_problem;
  };
  static constexpr std::chrono::seconds kRetry{2};

  DeviceThread(bool is_wanted, Work work) : work_(std::move(work)), is_wanted_(is_wanted), thread_([this] { run(); }) {}
  ~DeviceThread() { stop(); }
  DeviceThread(const DeviceThread&) = delete;
  DeviceThread& operator=(const DeviceThread&) = delete;

  void want(bool is_wanted) {
    const std::scoped_lock lock(mutex_);
    is_wanted_ = is_wanted;
    changed_.notify_one();
  }
  /// Ends the thread; it waits for the block of sound that is being transferred.
  void stop() {
    {
      const std::scoped_lock lock(mutex_);
      is_stopping_ = true;
      changed_.notify_one();
    }
    if (thread_.joinable()) thread_.join();
  }

  // The functions below are for Work::use, on this thread.

  [[nodiscard]] bool goes_on() {
    const std::scoped_lock lock(mutex_);
    return is_wanted_ && !is_stopping_;
  }
  void sleep_until(std::chrono::steady_clock::time_point due) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, due, [this] { return is_stopping_ || !is_wanted_; });
  }
  /// Says that the device works, so that an earlier problem is over.
  void works() { say(""); }

 private:
  void run() {
    for (;;) {
      {
        std::unique_lock lock(mutex_);
        if (!is_wanted_) said_.clear();  // it is told again when the device is wanted again
        changed_.wait(lock, [this] { return is_wanted_ || is_stopping_; });
        if (is_stopping_) return;
      }
      const Result<void> used = work_.use(*this);
      say(used || !goes_on() ? "" : to_string(used.error()));
      if (!used) sleep_until(std::chrono::steady_clock::now() + kRetry);
    }
  }
  void say(const std::string& problem) {
    if (problem == said_) return;
    said_ = problem;
    work_.on_problem(problem);
  }

  Work work_;
  std::mutex mutex_;  // guards the two members below
  bool is_wanted_;
  bool is_stopping_ = false;
  std::condition_variable changed_;
  std::string said_;
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::voice
