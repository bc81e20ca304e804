#include "server/capture/openni/timestamp_map.h"

namespace telepalp::capture {

SessionTime TimestampMap::map(std::chrono::microseconds driver, SessionTime arrival) {
  if (last_driver_ && driver <= *last_driver_) envelope_.restart();
  last_driver_ = driver;
  SessionTime mapped{envelope_.map(driver, arrival.time_since_epoch())};
  if (last_ && mapped <= *last_) mapped = *last_ + Nanoseconds{1};
  last_ = mapped;
  return mapped;
}

}  // namespace telepalp::capture
