#pragma once

#include <string>

#include "haptic_station/core/outbox/duration_histogram.h"
#include "messages/station.pb.h"

namespace telepalp::station {

/// Accumulates, for the log, each image's age when it becomes touchable: the time from its capture at the server to its
/// surface at this station. Owner: network thread.
class ImageAges {
 public:
  /// `clock_error_s`: bound on the error of the session clock.
  void add(const msg::SurfaceReport& report, double clock_error_s);
  /// Such as "843 images: their surfaces were touchable 61 ms (median) and 97 ms (99th percentile) after capture; the
  /// error of both is at most 3.2 ms". The 3.2 ms: largest bound so far on the clock's error. Empty without images.
  [[nodiscard]] std::string in_words() const;

 private:
  core::DurationHistogram ages_;
  double clock_error_s_ = 0.0;
};

}  // namespace telepalp::station
