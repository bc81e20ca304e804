#pragma once

#include <optional>
#include <string>

#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// The frames of a recording in order, with the times at which they were captured then.
class RecordedFrames {
 public:
  virtual ~RecordedFrames() = default;

  /// When the next frame was captured; nullopt at the end. A damaged part is passed over and counted.
  [[nodiscard]] virtual std::optional<SessionTime> peek() = 0;

  /// The next frame, decoded; nullopt when it turns out to be damaged. Only after peek() named it.
  [[nodiscard]] virtual std::optional<RgbdFrame> take() = 0;

  /// Passes over the frame that peek() named.
  virtual void skip() = 0;

  /// Starts again from the beginning.
  virtual void rewind() = 0;

  /// For people: what is wrong with the recording so far; empty when nothing is.
  [[nodiscard]] virtual std::string complaint() const = 0;
};

}  // namespace telepalp::server
