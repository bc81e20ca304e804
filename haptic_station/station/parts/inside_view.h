#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/core/inside/inner_surfaces_stage.h"
#include "haptic_station/core/inside/ultrasound_stage.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/threads/live_driver.h"

namespace telepalp::station {

/// What viewers are shown of the inside of the body: the layers' surfaces, once, and the ultrasound image of the probe,
/// 25 times a second. Drives the stages of both on a thread of their own, for which no other thread waits. Owner:
/// network thread.
class InsideView {
 public:
  struct Handlers {
    std::function<SessionTime()> now;  ///< session clock; called on any thread
    /// Called on the network thread when structures() has become known. `left_out`: layers that are not drawn.
    std::function<void(const std::vector<std::string>& left_out)> on_structures;
    std::function<void(const msg::UltrasoundImage&)> on_image;  ///< called on the network thread
  };

  /// Starts the thread, if the scene has layers or a probe.
  void start(boost::asio::io_context& network, const scenes::Scene& scene, Handlers handlers);
  /// Ends the thread within a fraction of a second: surfaces in the making are dropped.
  void end();

  /// The message of /station/inside; nullopt: not started, or the surfaces are not made yet. Without layers it is empty
  /// at once: an empty message removes the surfaces that an earlier station published.
  [[nodiscard]] std::optional<msg::InnerStructures> structures(
      SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const;

  /// How far the objects have moved with the body, for the next image.
  void set_objects(const loop::ObjectPlacements& objects) noexcept { objects_ = objects; }
  /// Asks for the next image when it is due.
  void look(SessionTime now, const loop::TickSample& tick,
            const Transform<HapticBase, DepthCamera>& haptic_from_camera);

 private:
  std::optional<core::InnerSurfacesStage> surfaces_;
  std::optional<core::UltrasoundStage> ultrasound_;  // only if the scene has a probe
  std::optional<LiveDriver<core::InnerSurfacesStage>> surfaces_driver_;
  std::optional<LiveDriver<core::UltrasoundStage>> ultrasound_driver_;
  std::optional<StageThread> thread_;  // only if the scene has layers or a probe; it ends before its drivers
  loop::ObjectPlacements objects_{};   // displacements in the newest StationCompensation
};

}  // namespace telepalp::station
