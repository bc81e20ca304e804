#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

#include "tools/replay/workers/cell_answer.h"

namespace telepalp::replay {

/// The workers whose Presence came lately. Pure: the caller gives the time. Owner: one thread.
class PresentWorkers {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Takes a worker's presence. Returns true if the worker is new.
  bool hear(const Presence& worker, TimePoint now) {
    constexpr std::size_t kMost = 10'000;
    const auto known = workers_.find(worker.name);
    if (known == workers_.end() && workers_.size() >= kMost) return false;
    workers_.insert_or_assign(worker.name, Seen{worker.build, now});
    return known == workers_.end();
  }
  /// Forgets each worker that has been silent for 7 s: three of its presences were lost.
  void forget_silent(TimePoint now) {
    static constexpr auto kLongestSilence = 3 * kPresenceEvery + std::chrono::seconds(1);
    std::erase_if(workers_, [now](const auto& one) { return now - one.second.heard > kLongestSilence; });
  }
  /// Workers of this build.
  [[nodiscard]] std::size_t count(const std::string& build) const {
    std::size_t count = 0;
    for (const auto& [name, seen] : workers_) count += seen.build == build ? 1U : 0U;
    return count;
  }

 private:
  struct Seen {
    std::string build;
    TimePoint heard;
  };
  std::map<std::string, Seen> workers_;  // by name
};

}  // namespace telepalp::replay
