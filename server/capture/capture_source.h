#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/capture/exposure.h"

namespace telepalp::capture {

/// State of a capture source, as shown to the technician: the same states as msg.CaptureState, with other numeric
/// values.
enum class CaptureState { Waiting, Live, Lost, Ended };

/// The images of a frame as a session file stores them.
struct CompressedFrame {
  std::string depth;         ///< a packet of the depth codec
  std::string depth_format;  ///< name of its codec mode
  std::string color;         ///< empty: no colour was recorded with this frame
  std::string color_format;  ///< "jpeg", or "vp8"
};

/// A source of RGB-D frames: a camera, a recording or a simulation. Owner: the capture thread.
class CaptureSource {
 public:
  virtual ~CaptureSource() = default;

  /// Waits at most `patience` for the next frame. nullopt: no frame came; state() tells whether this is a pause, a lost
  /// device or the end of a recording.
  [[nodiscard]] virtual std::optional<RgbdFrame> next(Nanoseconds patience) = 0;

  [[nodiscard]] virtual CaptureState state() const = 0;

  /// Text for the technician: the captured device or file, or the problem and its fix.
  [[nodiscard]] virtual std::string detail() const = 0;

  /// Text for the technician: the unreadable parts of a recording so far; empty when all parts were readable.
  [[nodiscard]] virtual std::string complaint() const { return {}; }

  /// nullopt: this source has no exposure to set.
  [[nodiscard]] virtual std::optional<ExposureLimits> exposure_limits() const { return std::nullopt; }
  [[nodiscard]] virtual Exposure exposure() const { return {}; }
  /// Error: the source has none, or its driver refuses it. It is restored when the camera is plugged in
  /// again.
  [[nodiscard]] virtual Result<void> set_exposure(const Exposure&) {
    return Error{.what = "this source has no exposure to set",
                 .where = "exposure",
                 .fix = "choose a camera whose driver offers it, or the synthetic patient"};
  }

  /// The compressed images of the frame that next() returned last; nullptr: the source has none.
  [[nodiscard]] virtual const CompressedFrame* compressed() const { return nullptr; }
};

/// Options of every source.
struct SourceOptions {
  wire::SessionClock clock{Nanoseconds{0}};
  bool loop = true;              ///< a recording restarts at its end
  bool paced = true;             ///< a recording plays in real time; false: as fast as next() is called
  bool keep_compressed = false;  ///< a session file fills compressed(), and leaves RgbdFrame::color empty
};

/// A camera that is connected to this machine.
struct FoundCamera {
  std::string spec;  ///< for open_source(): openni2:URI
  std::string name;  ///< of its maker, for the technician
};
/// Asks the drivers, which may take seconds.
[[nodiscard]] std::vector<FoundCamera> find_cameras();

/// Checks what needs no file or camera of `spec`, as for open_source(): its kind, and the words of a synthetic patient.
[[nodiscard]] Result<void> check_source(std::string_view spec);

/// Opens `spec`: openni2[:URI], oni:FILE, images:DIR, pcd:FILE, synthetic[:MODEL], session:FILE.mcap.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_source(std::string_view spec, const SourceOptions& options);

}  // namespace telepalp::capture
