#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "foxglove/CameraCalibration.pb.h"
#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/outbox/outbox.h"
#include "haptic_station/core/surface_stage.h"
#include "haptic_station/core/tick_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/core/virtual_effects.h"
#include "haptic_station/scenes/scene.h"
#include "tools/replay/cell/hands.h"
#include "tools/replay/cell/station_output.h"
#include "tools/replay/scenario/stopwatch.h"

namespace telepalp::replay {

/// The settings that all stations of a replay share.
struct StationSetup {
  const scenes::Scene& scene;
  surface::SurfaceSettings surface;
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  const RecordedHand* recorded = nullptr;  ///< nullptr: the scenario's script
};

/// The outcome of one tick.
struct TickOutcome {
  SessionTime at;
  Point<HapticBase> device{};  ///< true position, without the scenario's encoder glitches
  loop::TickOut act{};
  bool tracker_lost = false;
};

/// The station in virtual time: the stages of haptic_station/core, the haptic loop, the rig (device and tracker) and
/// telemetry, tick by tick. The stages take the scenario's StageTimes. Owner: one run.
class ReplayedStation {
 public:
  ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish);
  ~ReplayedStation();

  void arrived(core::ArrivedDepth frame);
  [[nodiscard]] TickOutcome tick(SessionTime now, Stopwatch& watch);

  /// Times of the frame whose surface the haptic loop or the collision detection got at the last tick; nullopt: it got
  /// none.
  [[nodiscard]] const std::optional<FrameTimes>& touchable() const noexcept { return touchable_; }
  /// True if the station requests a key frame. The call clears the request.
  [[nodiscard]] bool key_frame_wanted() noexcept { return std::exchange(key_frame_wanted_, false); }
  /// Frames that gave no surface when their turn came.
  [[nodiscard]] std::uint64_t undecodable() const noexcept { return undecodable_; }

 private:
  class Telemetry;
  ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish, core::BuiltEffects effects);
  [[nodiscard]] Point<HapticBase> device() const noexcept { return tool_ ? tool_->device : Point<HapticBase>{}; }
  [[nodiscard]] SessionTime clock(SessionTime now) const noexcept;
  [[nodiscard]] ports::DeviceReading spoiled(ports::DeviceReading reading, Nanoseconds since) const noexcept;
  [[nodiscard]] std::optional<loop::TouchableSurface> newer_surface(SessionTime true_now, Stopwatch& watch);
  [[nodiscard]] std::optional<loop::TouchableSurface> newer_plane(SessionTime true_now);
  void report(const msg::SurfaceReport& report, SessionTime true_now);

  Scenario scenario_;
  std::unique_ptr<ports::Rig> rig_;
  core::TickStage ticks_;
  core::SurfaceStage surfaces_;
  core::VirtualDriver<core::SurfaceStage> surface_driver_;
  core::VirtualEffects slow_effects_;
  std::optional<core::CollisionStage> collision_;  // nullopt: the surface is evaluated in the tick
  core::VirtualDriver<core::CollisionStage> collision_driver_;
  std::optional<loop::TouchableSurface> to_collision_;  // the newest surface that the collision detection has not got
  loop::TouchableSurface touched_;                      // the loop refers to it
  std::optional<FrameTimes> touchable_;
  std::unique_ptr<Telemetry> telemetry_;  // nullptr: no message is published
  std::optional<core::ToolAt> tool_;      // as the device measured it at the last tick; nullopt: before the first
  bool key_frame_wanted_ = false;
  std::uint64_t undecodable_ = 0;
};

}  // namespace telepalp::replay
