#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "server/plan/line_budget.h"

namespace telepalp::plan {

/// A line in virtual time, as the server sees it: it drains images in order, at the rate of the moment. An image that
/// comes while two of its stream wait replaces the older one. Repairs take a part of the rate.
class SimulatedLine {
 public:
  /// `rate_B_per_s`: of the line at a time [s]. `repairs`: share of the sent bytes that are repairs.
  explicit SimulatedLine(std::function<double(double at_s)> rate_B_per_s, double repairs = 0.0)
      : rate_(std::move(rate_B_per_s)), repairs_(repairs) {}

  struct Arrived {
    int stream;
    double captured_s;
    double at_s;
  };

  void offer(int stream, double bytes, double at_s) {
    ++report_.offered;
    const auto waits = [&](const Waiting& one) { return one.stream == stream && !one.started; };
    if (std::ranges::count_if(waiting_, waits) >= 2) {
      waiting_.erase(std::ranges::find_if(waiting_, waits));
      ++report_.dropped;
    }
    waiting_.push_back({stream, bytes * (1.0 + repairs_), bytes, at_s, false});
  }

  /// Drains until `to_s`.
  void run(double to_s) {
    double room = rate_(now_s_) * (to_s - now_s_);
    now_s_ = to_s;
    while (!waiting_.empty() && room > 0.0) {
      Waiting& first = waiting_.front();
      const double part = std::min(room, first.left);
      if (!std::exchange(first.started, true)) report_.sent_B += static_cast<std::uint64_t>(first.bytes);
      first.left -= part;
      room -= part;
      if (first.left > 0.0) break;
      arrived_.push_back({first.stream, first.captured_s, to_s});
      waiting_.pop_front();
    }
  }

  [[nodiscard]] const LineReport& report() const noexcept { return report_; }
  [[nodiscard]] LineReport& report() noexcept { return report_; }
  [[nodiscard]] const std::vector<Arrived>& arrived() const noexcept { return arrived_; }
  [[nodiscard]] double rate_B_per_s() const { return rate_(now_s_); }

 private:
  struct Waiting {
    int stream;
    double left;
    double bytes;
    double captured_s;
    bool started;
  };
  std::function<double(double)> rate_;
  double repairs_;
  double now_s_ = 0.0;
  std::deque<Waiting> waiting_;
  std::vector<Arrived> arrived_;
  LineReport report_;
};

}  // namespace telepalp::plan
