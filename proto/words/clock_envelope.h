#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace telepalp {

/// Maps another clock's time to ours from pairs (their stamp, our arrival time). The delivery delay is never negative,
/// so the smallest difference, arrival minus stamp, is the most accurate: the offset follows the lower envelope of the
/// differences. It falls at once and rises by at most `drift` seconds a second. A difference more than half a second
/// from the offset starts a new mapping.
class ClockEnvelope {
 public:
  using Nanoseconds = std::chrono::nanoseconds;
  static constexpr Nanoseconds kJump = std::chrono::milliseconds(500);
  static constexpr double kOscillatorDrift = 200e-6;  ///< [s/s] above the relative drift of two quartz oscillators

  /// `drift`: largest rise of the offset [s/s]. Pass more than the default for a clock that is slewed.
  explicit ClockEnvelope(double drift = kOscillatorDrift) noexcept : drift_(drift) {}

  /// Our time of the stamp `theirs`, which arrived at `ours`; never later than `ours`.
  [[nodiscard]] Nanoseconds map(Nanoseconds theirs, Nanoseconds ours) noexcept {
    const Nanoseconds observed = ours - theirs;
    if (!started_ || observed - offset_ > kJump || offset_ - observed > kJump) {
      if (started_) ++jumps_;
      offset_ = observed;
      started_ = true;
    } else {
      const Nanoseconds rise(static_cast<Nanoseconds::rep>(static_cast<double>((ours - last_).count()) * drift_));
      offset_ = std::min(offset_ + rise, observed);
    }
    last_ = ours;
    return theirs + offset_;
  }

  /// Starts a new mapping with the next pair.
  void restart() noexcept {
    if (started_) ++jumps_;
    started_ = false;
  }

  /// Our time minus theirs as of the last map(); zero before the first.
  [[nodiscard]] Nanoseconds difference() const noexcept { return offset_; }

  /// How often a mapping was replaced by a new one.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  double drift_;
  bool started_ = false;
  Nanoseconds offset_{0};
  Nanoseconds last_{0};
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp
