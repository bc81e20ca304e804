#pragma once

#include <memory>
#include <optional>

#include "foxglove/CameraCalibration.pb.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "tools/replay/cell/hands.h"
#include "tools/replay/cell/surface_stage.h"

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

/// The station without its clock, sockets and threads: surface stage, haptic loop, rig (device and tracker) and
/// telemetry, tick by tick. Owner: one run.
class ReplayedStation {
 public:
  ReplayedStation(const StationSetup& setup, const Scenario& scenario, Publish publish);
  ~ReplayedStation();

  void arrived(ArrivedDepth frame);
  [[nodiscard]] TickOutcome tick(SessionTime now, Stopwatch& watch);

  /// Times of the frame whose surface the haptic loop got at the last tick; nullopt: it got none.
  [[nodiscard]] const std::optional<FrameTimes>& touchable() const noexcept { return touchable_; }
  [[nodiscard]] std::uint64_t undecodable() const noexcept { return surfaces_.undecodable(); }

 private:
  class Telemetry;
  [[nodiscard]] SessionTime clock(SessionTime now) const noexcept;
  [[nodiscard]] ports::DeviceReading spoiled(ports::DeviceReading reading, Nanoseconds since) const noexcept;
  void report_touchable(const BuiltSurface& built, SessionTime true_now);

  Scenario scenario_;
  std::unique_ptr<ports::Rig> rig_;
  loop::HapticLoop loop_;
  SurfaceStage surfaces_;
  std::optional<FrameTimes> touchable_;
  std::shared_ptr<const surface::SurfaceSnapshot> touched_;  // the snapshot that the loop refers to
  std::unique_ptr<Telemetry> telemetry_;                     // nullptr: no message is published
  Point<HapticBase> device_;
};

}  // namespace telepalp::replay
