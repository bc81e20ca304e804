#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/capture/capture_source.h"

namespace telepalp::server {

/// Frames that lie ready, by number; `captured` and `sequence` are set when they are played.
struct FrameSequence {
  std::size_t count = 0;
  Nanoseconds period{};
  std::function<Result<RgbdFrame>(std::size_t number)> load;
  std::string description;  ///< for people; warnings included
};

/// Plays a sequence as a camera would: each frame at its time, those that nobody fetched in time dropped. A frame that
/// cannot be loaded ends the source, and detail() says why.
[[nodiscard]] std::unique_ptr<CaptureSource> play(FrameSequence sequence, const SourceOptions& options);

}  // namespace telepalp::server
