#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace telepalp::tracking {

/// Maps another clock's time to ours, from pairs (its time, ours when we learnt it). Learning is only ever late, so
/// the least difference is the truest; it may rise by `drift`: 200 ppm is more than two quartzes differ, a clock that
/// is slewed needs more. A jump of over half a second begins anew. Pure.
class ClockEnvelope {
 public:
  using Nanoseconds = std::chrono::nanoseconds;

  explicit ClockEnvelope(double drift = 200e-6) noexcept : drift_(drift) {}

  /// Our time for `theirs`, which we learnt at `ours`; never later than `ours`.
  [[nodiscard]] Nanoseconds map(Nanoseconds theirs, Nanoseconds ours) noexcept {
    constexpr Nanoseconds kJump = std::chrono::milliseconds(500);
    const Nanoseconds difference = ours - theirs;
    const Nanoseconds rise(static_cast<Nanoseconds::rep>(static_cast<double>((ours - last_).count()) * drift_));
    last_ = ours;
    const bool jumped = difference - least_ > kJump || least_ - difference > kJump;
    if (!learnt_ || jumped)
      least_ = difference;
    else
      least_ = std::min(least_ + rise, difference);
    learnt_ = true;
    return theirs + least_;
  }

  /// Ours less theirs, as last learnt; zero before the first map().
  [[nodiscard]] Nanoseconds difference() const noexcept { return least_; }

 private:
  double drift_;
  Nanoseconds least_{0};
  bool learnt_ = false;
  Nanoseconds last_{0};
};

}  // namespace telepalp::tracking
