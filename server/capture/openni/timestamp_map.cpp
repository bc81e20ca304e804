#include "server/capture/openni/timestamp_map.h"

#include <algorithm>

namespace telepalp::server {

SessionTime TimestampMap::map(std::chrono::microseconds driver, SessionTime arrival) {
  const Nanoseconds observed = arrival.time_since_epoch() - driver;
  if (anchor_) {
    const Nanoseconds since = driver - anchor_->driver;
    const Nanoseconds difference = observed - anchor_->offset;
    if (since <= Nanoseconds{0} || difference > kJump || difference < -kJump) {
      anchor_.reset();
      ++jumps_;
    } else {
      const auto rise = Nanoseconds{static_cast<std::int64_t>(kMaxDrift * static_cast<double>(since.count()))};
      anchor_ = Anchor{std::min(observed, anchor_->offset + rise), driver};
    }
  }
  if (!anchor_) anchor_ = Anchor{observed, driver};
  SessionTime mapped{anchor_->offset + driver};
  if (last_ && mapped <= *last_) mapped = *last_ + Nanoseconds{1};
  last_ = mapped;
  return mapped;
}

}  // namespace telepalp::server
