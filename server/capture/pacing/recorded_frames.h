#pragma once

#include <optional>
#include <string>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// The frames of a recording in order, with their recorded capture times.
class RecordedFrames {
 public:
  virtual ~RecordedFrames() = default;

  /// Capture time of the next frame by the recording's clock; nullopt at the end. Skips damaged parts (complaint()).
  [[nodiscard]] virtual std::optional<SessionTime> peek() = 0;

  /// Decodes the next frame; nullopt when it is damaged. Call peek() first.
  [[nodiscard]] virtual std::optional<RgbdFrame> take() = 0;

  /// The compressed images of the frame that take() returned last; nullptr: the recording has none.
  [[nodiscard]] virtual const CompressedFrame* compressed() const { return nullptr; }

  /// Skips the frame that peek() announced.
  virtual void skip() = 0;

  /// Restarts at the beginning.
  virtual void rewind() = 0;

  /// Text for the technician: damage found so far; empty when no damage was found.
  [[nodiscard]] virtual std::string complaint() const = 0;
};

}  // namespace telepalp::capture
