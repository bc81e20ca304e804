#pragma once

#include <chrono>

#include "tools/replay/workers/inbox.h"
#include "tools/replay/workers/present_workers.h"

namespace telepalp::replay {

/// Counts the workers that a sweep can use, and logs why there is none. Owner: the sweep's thread.
class WorkerWatch {
 public:
  using TimePoint = PresentWorkers::TimePoint;

  /// `build`: of the sweep's program. `began`: when the sweep began.
  WorkerWatch(std::string build, TimePoint began) : build_(std::move(build)), began_(began) {}

  /// Takes the notes of the subject kWorkerIsHere; must outlive the subscription.
  [[nodiscard]] Inbox& inbox() noexcept { return inbox_; }

  /// Reads the inbox. Logs each worker of another build once, and each time that no worker of this build is left.
  /// `address`: of the cluster, without passwords.
  void look(TimePoint now, const std::string& address);
  /// Workers of the sweep's build.
  [[nodiscard]] std::size_t count() const { return workers_.count(build_); }

 private:
  std::string build_;
  TimePoint began_;
  Inbox inbox_;
  PresentWorkers workers_;
  bool said_nobody_ = false;
};

}  // namespace telepalp::replay
