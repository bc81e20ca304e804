#pragma once

#include <optional>
#include <string>

#include "haptic_station/station/telemetry/dropped_messages.h"
#include "haptic_station/station/telemetry/image_ages.h"

namespace telepalp::station {

/// What the log says of the server's images: their ages, those that gave no surface, and whether depth is lossless.
/// Owner: network thread.
class ImageLog {
 public:
  /// Words about the fidelity of the touched depth.
  struct Fidelity {
    std::string text;
    bool is_warning = false;
  };

  /// Adds an image that became touchable. `clock_error_s`: bound on the error of the session clock. Returns words when
  /// the fidelity of depth has changed: near-lossless depth differs from the measurement, so the log states its error
  /// bound.
  [[nodiscard]] std::optional<Fidelity> add(const msg::SurfaceReport& report, double clock_error_s);
  [[nodiscard]] DroppedMessages& dropped() noexcept { return dropped_; }
  [[nodiscard]] std::string ages_in_words() const { return ages_.in_words(); }

 private:
  ImageAges ages_;
  DroppedMessages dropped_;
  std::string depth_;  // last description: depth lossless, or its error bound
};

}  // namespace telepalp::station
