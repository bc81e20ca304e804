#pragma once

#include <mutex>
#include <thread>
#include <vector>

#include "proto/words/time.h"
#include "tests/bench/distribution.h"
#include "tests/bench/site/two_networks.h"

namespace telepalp::bench {

/// Reads, every 5 ms, how long the queue from the patient to the doctor is.
class QueueWatch {
 public:
  QueueWatch(const TwoNetworks& networks, const SiteLine& line);

  /// The queueing delay at `at` (the wall clock): the last reading before it; 0 before the first one.
  [[nodiscard]] Nanoseconds at(Nanoseconds at) const;
  /// All readings [ms] of [from, until).
  [[nodiscard]] Distribution between_ms(Nanoseconds from, Nanoseconds until) const;

 private:
  struct Reading {
    Nanoseconds at{0};
    Nanoseconds queue{0};
  };
  void read(const std::stop_token& stop);

  double line_B_per_s_;
  mutable std::mutex mutex_;  ///< guards readings_
  std::vector<Reading> readings_;
  std::jthread reader_;
};

/// The wall clock, which a server's session clock follows from its start.
[[nodiscard]] Nanoseconds wall_clock() noexcept;

}  // namespace telepalp::bench
