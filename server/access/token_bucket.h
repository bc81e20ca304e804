#pragma once

#include <algorithm>
#include <chrono>

namespace telepalp::access {

/// A budget that refills with time (token bucket). It may be overdrawn: then it refills from below zero. Pure: time is
/// an argument, counted from any origin; a time before an earlier one refills nothing.
class TokenBucket {
 public:
  TokenBucket(double per_s, double most) noexcept : per_s_(per_s), most_(most), left_(most) {}

  [[nodiscard]] bool has(double amount, std::chrono::nanoseconds now) noexcept {
    const double elapsed_s = started_ ? std::max(0.0, std::chrono::duration<double>(now - last_).count()) : 0.0;
    started_ = true;
    last_ = now;
    left_ = std::min(most_, left_ + elapsed_s * per_s_);
    return left_ >= amount;
  }
  void spend(double amount) noexcept { left_ -= amount; }
  [[nodiscard]] bool is_full() const noexcept { return left_ >= most_; }

 private:
  double per_s_;
  double most_;
  double left_;
  std::chrono::nanoseconds last_{};
  bool started_ = false;
};

}  // namespace telepalp::access
