#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// A sequence of frames that are loaded by number. play() sets their `captured` and `sequence`.
struct FrameSequence {
  std::size_t count = 0;
  Nanoseconds period{};
  std::function<Result<RgbdFrame>(std::size_t number)> load;
  std::string description;  ///< text for the technician, with warnings
};

/// Plays a sequence like a camera: frame k is due k periods after the first; a frame that was not fetched before the
/// next is due is dropped. When a frame cannot be loaded, the source ends and detail() gives the reason.
[[nodiscard]] std::unique_ptr<CaptureSource> play(FrameSequence sequence, const SourceOptions& options);

}  // namespace telepalp::capture
