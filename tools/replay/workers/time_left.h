#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

namespace telepalp::replay {

/// Estimates how long the rest of a sweep takes. Only the newest 32 cells count, because workers come and go. Pure: the
/// caller gives the time. Owner: one thread.
class TimeLeft {
 public:
  /// `now_s`: when the sweep began to wait for workers [s].
  explicit TimeLeft(double now_s) : times_s_{now_s} {}
  /// A cell is finished.
  void finished(double now_s);
  /// Seconds until `cells` more are finished; nullopt: none has been finished. Grows while the next cell is late.
  [[nodiscard]] std::optional<double> left_s(std::size_t cells, double now_s) const;

 private:
  std::deque<double> times_s_;  // when the window began, then when each of its cells was finished
};

/// "40 s", "12 min", "3 h 20 min".
[[nodiscard]] std::string span_of_time(double seconds);

}  // namespace telepalp::replay
