#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "codec/depth_stream.h"
#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/build/setting_choice.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/key_frame_request.h"
#include "proto/wire/message.h"
#include "proto/wire/session_clock.h"
#include "proto/words/latest_value.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The surface thread: makes a touchable surface from the newest depth message. A message behind which a newer one
/// waits is dropped and counted; it is still decoded if a newer frame is predicted from it. While 300 messages or
/// 32 MiB wait, further messages are dropped undecoded, and the next predicted frame leads to a key frame request. The
/// haptic thread never waits for this thread. While depth cannot be decoded because a reference frame is missing, the
/// last surface stays. When the session clock has stepped back by 1 s or more, the builder discards its temporal
/// average and begins anew with the next image.
class SurfaceWorker {
 public:
  /// Returns haptic_from_camera for an image. Called on the surface thread, with each image until it returns a value.
  using Placement =
      std::function<std::optional<Transform<HapticBase, DepthCamera>>(const DepthImage&, const Intrinsics&)>;
  struct Handlers {
    std::function<SessionTime()> now;                          ///< session clock; called on the surface thread
    std::function<void(const msg::SurfaceReport&)> on_report;  ///< called on the surface thread
    std::function<void(const Error&)> on_bad_frame;            ///< called on the surface thread
    /// Called on the surface thread when `unreadable` and the frames after it cannot be decoded without a key frame.
    std::function<void(const wire::Message& unreadable)> request_key_frame;
    /// Called on the surface thread with each decoded image, before its surface is built; may be empty.
    std::function<void(const DepthImage&, const Intrinsics&, const Transform<HapticBase, DepthCamera>&)> on_image{};
  };

  /// `device`: its position in H. `effects`: the scene's; the motion of the skin above each inner object is tracked.
  SurfaceWorker(const surface::SurfaceSettings& settings, Placement placement, Handlers handlers,
                LatestValue<loop::TouchableSurface>& to_haptic, LatestValue<Point<HapticBase>>& device,
                const effects::EffectBank& effects = {});
  ~SurfaceWorker();
  SurfaceWorker(const SurfaceWorker&) = delete;
  SurfaceWorker& operator=(const SurfaceWorker&) = delete;

  /// A depth message, its camera's model and the time of its arrival. offer() queues it and is for the network thread.
  struct Work {
    wire::Message depth;
    Intrinsics camera;
    SessionTime received;
  };
  void offer(Work work);

  /// Number of messages that have given no surface: dropped, damaged or still waiting. Network thread only.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return offered_ - built_.load(std::memory_order_relaxed); }

 private:
  void work_off(const Work& work);
  Result<codec::DecodedDepth> read(const msg::DepthImage& message);
  Result<msg::SurfaceReport> build(const Work& work, const msg::DepthImage& message,
                                   const codec::DecodedDepth& decoded_depth);
  [[nodiscard]] std::optional<surface::Reach> reach();
  void begin_anew_if_clock_went_back(SessionTime captured, SessionTime now);
  void judge(msg::SurfaceReport& report, SessionTime captured, double cost_s);

  codec::DepthReader reader_;                // owner: surface thread
  wire::KeyFrameRequest key_frame_request_;  // owner: surface thread
  surface::SettingChoice choice_;            // owner: surface thread
  surface::SurfaceBuilder builder_;          // owner: surface thread
  SessionTime last_captured_{};              // owner: surface thread
  Placement placement_;
  std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera_;  // owner: surface thread
  Handlers handlers_;
  LatestValue<loop::TouchableSurface>& to_haptic_;
  LatestValue<Point<HapticBase>>& device_;     // position in H, written by: haptic thread
  const effects::EffectBank effects_;          // owner: surface thread
  bool device_known_ = false;                  // owner: surface thread
  std::atomic<int> waiting_{0};                // messages offered and not yet taken by the surface thread
  std::atomic<std::size_t> waiting_bytes_{0};  // of these messages
  std::uint64_t offered_ = 0;                  // owner: network thread
  std::atomic<std::uint64_t> built_{0};
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stay_;
  std::thread thread_;
};

}  // namespace telepalp::station
