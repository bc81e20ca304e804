#pragma once

#include <glib.h>

#include <atomic>
#include <functional>
#include <thread>

namespace telepalp::ice {

/// The thread on which libnice keeps the timers and sockets of all agents of this process. It begins with the first
/// agent. At the process's end it waits up to 1 s until relays have been told that their allocations end.
class GlibLoop {
 public:
  static GlibLoop& of_process();
  GlibLoop();
  ~GlibLoop();
  GlibLoop(const GlibLoop&) = delete;
  GlibLoop& operator=(const GlibLoop&) = delete;

  [[nodiscard]] GMainContext* context() const noexcept { return context_; }
  /// Runs `work` on the thread. Any thread may call it.
  void run(std::function<void()> work);

  void agent_begins() noexcept { ++agents_; }
  void agent_has_ended() noexcept { --agents_; }

 private:
  GMainContext* context_;
  GMainLoop* loop_;
  std::atomic<int> agents_{0};
  std::thread thread_;
};

}  // namespace telepalp::ice
