#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

namespace telepalp::replay {

/// Estimates how long the rest of a sweep takes, from the newest cells: workers come and go, so the pace of an hour ago
/// says nothing. Pure: the caller gives the time. Owner: one thread.
class TimeLeft {
 public:
  /// `now_s`: when the sweep began to wait [s].
  explicit TimeLeft(double now_s) : times_s_{now_s} {}
  /// A cell is finished.
  void finished(double now_s);
  /// Seconds until `cells` more are finished; nullopt: no cell has been finished yet. While none comes, it grows.
  [[nodiscard]] std::optional<double> left_s(std::size_t cells, double now_s) const;

 private:
  std::deque<double> times_s_;  // the beginning of the window, then of each cell in it
};

/// "40 s", "12 min", "3 h 20 min".
[[nodiscard]] std::string span_of_time(double seconds);

}  // namespace telepalp::replay
