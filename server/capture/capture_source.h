#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// How a source is doing, as the technician should know it. Mirrors msg.CaptureState.
enum class CaptureState { Waiting, Live, Lost, Ended };

/// Where RGB-D frames come from. One thread, the capture thread, owns a source and calls it.
class CaptureSource {
 public:
  virtual ~CaptureSource() = default;

  /// Waits for the next frame, at the source's own pace, at most `patience`. nullopt: none came in that time, and
  /// state() says whether that is a pause, a lost device or the end of a recording.
  [[nodiscard]] virtual std::optional<RgbdFrame> next(Nanoseconds patience) = 0;

  [[nodiscard]] virtual CaptureState state() const = 0;

  /// For people: what is being captured, or what went wrong and how to fix it.
  [[nodiscard]] virtual std::string detail() const = 0;

  /// For people: what of a recording could not be read so far, and where; empty when all of it could.
  [[nodiscard]] virtual std::string complaint() const { return {}; }
};

/// How any source is opened.
struct SourceOptions {
  wire::SessionClock clock{Nanoseconds{0}};
  bool loop = true;   ///< a recording starts again at its end
  bool paced = true;  ///< a recording plays at its own speed; false: as fast as it is asked
};

/// Opens `spec`: openni2[:URI], oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL], session:FILE.mcap.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_source(std::string_view spec, const SourceOptions& options);

}  // namespace telepalp::server
