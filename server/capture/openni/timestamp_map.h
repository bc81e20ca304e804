#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/time.h"

namespace telepalp::server {

/// Maps a driver's timestamps, of whatever epoch, to session time. A frame never arrives before it was exposed, and the
/// quickest arrivals are the truest: the offset follows the lower envelope of (arrival - driver time), falls at once,
/// and rises at most kMaxDrift, which is more than any oscillator's. A driver clock that steps back or leaps ahead (a
/// recording that starts over, a device that resets) begins a new mapping; session times still never go backwards.
class TimestampMap {
 public:
  static constexpr double kMaxDrift = 200e-6;       ///< seconds a second
  static constexpr Nanoseconds kJump{500'000'000};  ///< disagreement beyond this is another time line

  /// The session time of a frame that the driver stamped `driver` and that was in our hands at `arrival`. At most
  /// `arrival`, unless that would go back behind an earlier answer: then the earlier answer plus 1 ns.
  [[nodiscard]] SessionTime map(std::chrono::microseconds driver, SessionTime arrival);

  /// How often the driver's clock began anew.
  [[nodiscard]] std::uint64_t jumps() const noexcept { return jumps_; }

 private:
  struct Anchor {
    Nanoseconds offset{};  // session minus driver
    std::chrono::microseconds driver{};
  };
  std::optional<Anchor> anchor_;
  std::optional<SessionTime> last_;
  std::uint64_t jumps_ = 0;
};

}  // namespace telepalp::server
