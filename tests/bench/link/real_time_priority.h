#pragma once

#include <pthread.h>
#include <sched.h>

namespace telepalp::bench::link {

/// Real-time priority of this thread while the object lives. Threads that it starts meanwhile inherit it.
class RealTimePriority {
 public:
  RealTimePriority() {
    pthread_getschedparam(pthread_self(), &policy_, &before_);
    const sched_param first{.sched_priority = sched_get_priority_min(SCHED_RR)};
    granted_ = pthread_setschedparam(pthread_self(), SCHED_RR, &first) == 0;
  }
  ~RealTimePriority() {
    if (granted_) pthread_setschedparam(pthread_self(), policy_, &before_);
  }
  RealTimePriority(const RealTimePriority&) = delete;
  RealTimePriority& operator=(const RealTimePriority&) = delete;
  [[nodiscard]] bool granted() const noexcept { return granted_; }

 private:
  int policy_ = 0;
  sched_param before_{};
  bool granted_ = false;
};

}  // namespace telepalp::bench::link
