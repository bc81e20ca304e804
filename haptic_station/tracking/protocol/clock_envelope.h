#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace telepalp::tracking {

/// Maps a remote clock to the local clock, from pairs (remote time stamp, local time of arrival). Delay only ever
/// increases the difference local - remote, so the least difference is the most accurate. The estimate may rise by
/// `drift` per second, to follow clocks that drift apart: 200 ppm covers two quartz oscillators; a slewed clock needs
/// more. A jump of over 0.5 s restarts the estimate. Pure.
class ClockEnvelope {
 public:
  using Nanoseconds = std::chrono::nanoseconds;

  explicit ClockEnvelope(double drift = 200e-6) noexcept : drift_(drift) {}

  /// Local time of the remote time stamp `theirs`, which arrived at local time `ours`; never later than `ours`.
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

  /// The newest estimate of local - remote time; zero before the first map().
  [[nodiscard]] Nanoseconds difference() const noexcept { return least_; }

 private:
  double drift_;
  Nanoseconds least_{0};
  bool learnt_ = false;
  Nanoseconds last_{0};
};

}  // namespace telepalp::tracking
