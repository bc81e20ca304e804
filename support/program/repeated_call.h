#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace telepalp::program {

/// Makes a call once per period, on a thread of its own, first after one period. The destructor waits for a call that
/// runs; none follows.
class RepeatedCall {
 public:
  RepeatedCall(std::chrono::milliseconds period, std::function<void()> call)
      : thread_([period, call = std::move(call)](const std::stop_token& stop) {
          std::mutex mutex;
          std::condition_variable_any stopped;
          std::unique_lock lock(mutex);
          while (!stopped.wait_for(lock, stop, period, [&stop] { return stop.stop_requested(); })) call();
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace telepalp::program
