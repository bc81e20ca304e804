#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "proto/words/repeats/repeated_errors.h"

namespace telepalp::station {

/// Messages of the server that the station could not use, for the log. A camera that sees no patient would fill the log
/// with 30 lines a second, so RepeatedErrors chooses the lines. Pure: the caller gives the time. Owner: network thread.
class DroppedMessages {
 public:
  using TimePoint = RepeatedErrors::TimePoint;

  /// Counts a depth image that gave no surface. Returns the line for the log when one is due, such as "depth image
  /// dropped, 151 so far for this reason: …".
  [[nodiscard]] std::optional<std::string> add_image(const Error& error, TimePoint now);
  /// The same for another message that is not of its topic's type, such as one that was cut short.
  [[nodiscard]] std::optional<std::string> add_unreadable(std::string_view topic, TimePoint now);

  [[nodiscard]] std::uint64_t images() const noexcept { return images_; }
  /// The error of the newest dropped image; nullopt before the first one.
  [[nodiscard]] const std::optional<Error>& newest_image() const noexcept { return newest_image_; }

 private:
  RepeatedErrors lines_;
  std::optional<Error> newest_image_;
  std::uint64_t images_ = 0;
};

}  // namespace telepalp::station
