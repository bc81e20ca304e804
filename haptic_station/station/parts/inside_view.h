#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "haptic_station/station/inside/inside_thread.h"

namespace telepalp::station {

/// What viewers are shown of the inside of the body: the layers' surfaces, once, and the ultrasound image of the probe,
/// 25 times a second. Owner: network thread.
class InsideView {
 public:
  /// Called on the inside thread; both must post to the network thread.
  using Handlers = InsideThread::Handlers;

  /// Starts the inside thread. Without layers and probe there is none, and structures() is empty at once, not nullopt: a
  /// message without structures replaces that of a station before this one.
  void start(const scenes::Scene& scene, Handlers handlers);
  void end() { thread_.reset(); }

  void set_structures(msg::InnerStructures structures) { structures_ = std::move(structures); }
  /// The message of /station/inside; nullopt: the surfaces are not made yet.
  [[nodiscard]] std::optional<msg::InnerStructures> structures(
      SessionTime now, const Transform<HapticBase, DepthCamera>& haptic_from_camera) const;

  /// How far the objects have moved with the body, for the next image.
  void set_objects(const loop::ObjectPlacements& objects) noexcept { objects_ = objects; }
  /// Asks for the next image when it is due.
  void look(const loop::TickSample& tick, const Transform<HapticBase, DepthCamera>& haptic_from_camera);

 private:
  std::optional<InsideThread> thread_;              // only if the scene has layers or a probe
  std::optional<msg::InnerStructures> structures_;  // once thread_ has made them
  loop::ObjectPlacements objects_{};                // displacements in the newest StationCompensation
  std::chrono::steady_clock::time_point next_image_;
};

}  // namespace telepalp::station
