#pragma once

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include "haptic_station/loop/body_frame.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/inside/inside_messages.h"

namespace telepalp::station {

/// The thread that makes the pictures from inside the body: first, once, the surfaces of the scene's layers, and then
/// the images of the scene's ultrasound probe. Station starts it only for a scene with layers or a probe. No other
/// thread waits for its results.
class InsideThread {
 public:
  /// Both handlers are called on the thread that this object starts.
  struct Handlers {
    std::function<void(InnerSurfaces)> on_structures;
    std::function<void(msg::UltrasoundImage)> on_image;
  };

  InsideThread(const scenes::Scene& scene, Handlers handlers);
  ~InsideThread();
  InsideThread(const InsideThread&) = delete;
  InsideThread& operator=(const InsideThread&) = delete;

  [[nodiscard]] bool has_probe() const noexcept { return settings_.has_value(); }

  /// The probe at a tick, the camera's pose, and how far the layers have moved with the body.
  struct View {
    loop::TickSample tick;
    Transform<HapticBase, DepthCamera> haptic_from_camera;
    loop::ObjectPlacements objects;  ///< one for each effect, in the scene's order
  };
  /// Asks for the image of a view; ignored without a probe, or while an earlier image is computed. Network thread only.
  void offer(const View& view);

 private:
  [[nodiscard]] msg::UltrasoundImage image_of(const View& view) const;

  std::vector<scenes::SceneLayer> layers_;
  std::optional<ultrasound::BModeSettings> settings_;  // nullopt: the scene has no probe
  Handlers handlers_;
  std::atomic<bool> busy_{false};
  boost::asio::io_context io_{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stay_;
  std::thread thread_;
};

}  // namespace telepalp::station
