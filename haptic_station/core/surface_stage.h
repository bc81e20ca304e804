#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "codec/depth_stream.h"
#include "haptic_station/core/stage_step.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/build/setting_choice.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/key_frame_request.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::core {

/// A depth message, its camera's model and the time of its arrival.
struct ArrivedDepth {
  wire::Message depth;
  Intrinsics camera;
  SessionTime received;
  /// The image that `depth` decodes to, if the driver knows it, so that many runs over one source decode it once. It
  /// must need no frame before it. Then `depth` need hold no packet.
  std::shared_ptr<const DepthImage> decoded = nullptr;
};

/// An image of a simulated camera, for which nothing is coded and nothing crosses a network.
[[nodiscard]] ArrivedDepth seen_image(DepthImage image, const Intrinsics& camera, SessionTime captured,
                                      std::uint64_t sequence, SessionTime received);

/// Makes a touchable surface from the newest depth message: decoding, the choice of the setting, building, the marks
/// above the scene's objects, and the report. A message behind which a newer one waits is dropped; it is still decoded
/// if a newer frame is predicted from it. While 300 messages or 32 MiB wait, further messages are dropped undecoded,
/// and the next predicted frame leads to a key frame request. While depth cannot be decoded because a reference frame
/// is missing, no surface is made. In an image with a window, the pixels outside the window count as not measured, so
/// that no surface is made from depth that is not exact. When the session clock has stepped back by 1 s or more, the
/// builder discards its temporal average and begins again with the next image.
///
/// A driver calls take(), run() and hands the result over; the results depend on nothing but the jobs, the positions
/// and the times that it gives. Owner: one thread; only admit() may be called on another one.
class SurfaceStage {
 public:
  /// Returns haptic_from_camera for an image. Called in run(), with each image until it returns a value.
  using Placement =
      std::function<std::optional<Transform<HapticBase, DepthCamera>>(const DepthImage&, const Intrinsics&)>;
  /// Called in run() with each decoded image, before its surface is built.
  using OnImage = std::function<void(const DepthImage&, const Intrinsics&, const Transform<HapticBase, DepthCamera>&)>;

  /// All that one run depends on, beside the stage's own state and the times of its steps.
  struct Job {
    std::vector<ArrivedDepth> messages;       ///< in order of arrival; the last one becomes the surface
    std::optional<Point<HapticBase>> device;  ///< its position in H; nullopt, before the first tick: the whole image
    SessionTime begun{};
    bool accept_object = false;  ///< the doctor accepts the object over the device's place as skin
  };
  struct Result {
    std::optional<loop::TouchableSurface> surface;  ///< numbered from 1
    msg::SurfaceReport report;                      ///< meaningless without a surface
    std::optional<Error> error;                     ///< to be told to the operator
    std::optional<wire::Message> unreadable;  ///< it and the frames after it cannot be decoded without a key frame
    std::optional<Transform<HapticBase, DepthCamera>> placed;  ///< the place, from the run that found it
    SessionTime done{};
  };

  /// `effects`: the scene's; the motion of the skin above each inner object is tracked. `on_image`: may be empty.
  SurfaceStage(const surface::SurfaceSettings& settings, Placement placement, const effects::EffectBank& effects,
               OnImage on_image = {});

  /// True if a message of that size may wait; arrived() must follow. Counts what is refused as dropped.
  [[nodiscard]] bool admit(std::size_t bytes) noexcept;
  void arrived(ArrivedDepth message);
  /// With the next job, the object over the device's place becomes skin as soon as the device is above it.
  void accept_object() noexcept { accept_object_ = true; }
  /// All waiting messages, as the next run's job; nullopt: none waits.
  [[nodiscard]] std::optional<Job> take(SessionTime now, const std::optional<Point<HapticBase>>& device);
  [[nodiscard]] Result run(const Job& job, const StepTime& time);

  /// Number of messages that were admitted or refused and have given no surface. On the thread that calls admit().
  [[nodiscard]] std::uint64_t dropped() const noexcept { return offered_ - built_.load(std::memory_order_relaxed); }
  [[nodiscard]] const surface::SurfaceSettings& setting() const noexcept { return choice_.now(); }

 private:
  struct Decoded {
    msg::DepthImage message;
    std::shared_ptr<const DepthImage> image;  // shared: the driver may have known it
    codec::DepthMode mode = codec::DepthMode::Fast;
    std::optional<DepthWindow> window = {};  // nullopt: the image has no window
  };
  void skip(const ArrivedDepth& message);
  telepalp::Result<void> decode(const ArrivedDepth& newest, Decoded& depth);
  void fail(const ArrivedDepth& newest, const Error& error, Result& result);
  telepalp::Result<void> build(const ArrivedDepth& newest, const Decoded& depth, const Job& job, const StepTime& time,
                               Result& result);
  void report_window(const Decoded& depth, const Job& job, const Intrinsics& camera, msg::SurfaceReport& report) const;
  bool place(const Decoded& depth, const Intrinsics& camera, Result& result);
  void begin_anew_if_clock_went_back(SessionTime captured, SessionTime now);
  void judge(msg::SurfaceReport& report, SessionTime captured, double cost_s);

  std::deque<ArrivedDepth> waiting_;
  bool accept_object_ = false;  // for the next job
  codec::DepthReader reader_;
  wire::KeyFrameRequest key_frame_request_;
  surface::SettingChoice choice_;
  surface::SurfaceBuilder builder_;
  SessionTime last_captured_{};
  Placement placement_;
  const effects::EffectBank effects_;
  OnImage on_image_;
  std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera_;
  std::uint64_t surfaces_ = 0;
  std::atomic<int> admitted_{0};                // messages admitted and not yet taken
  std::atomic<std::size_t> admitted_bytes_{0};  // of these messages
  std::uint64_t offered_ = 0;                   // owner: the thread that calls admit()
  std::atomic<std::uint64_t> built_{0};
};

}  // namespace telepalp::core
