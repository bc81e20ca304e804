#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/collision_stage.h"
#include "haptic_station/core/inside/inner_surfaces_stage.h"
#include "haptic_station/core/inside/ultrasound_stage.h"
#include "haptic_station/core/surface_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/station/bill/body_stream.h"
#include "haptic_station/station/rigs/scene_parts.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "haptic_station/station/threads/haptic_thread.h"

namespace telepalp::station {

/// The parts of a station whose processor time the bill states. After each colon: what one step of the part is.
enum class Part : std::uint8_t {
  Loop,       ///< the haptic thread: a tick, with its waking in real time
  Surface,    ///< the surface thread: a depth image, from its message to the snapshot with the marks of the objects
  Collision,  ///< the collision thread of settings that are too slow for a tick: a plane
  Inside,     ///< the ultrasound image under the probe: an image
  Messages,   ///< the network thread without its sockets: what it does every 10 ms
  Effects,    ///< the threads of slow effects: one run computes one local model
};
inline constexpr std::size_t kPartCount = 6;

/// Processor time of each part [us], and the messages published, over some session time.
struct StationCost {
  std::array<double, kPartCount> spent_us{};
  std::array<core::DurationHistogram, kPartCount> steps{};
  double seconds = 0.0;

  void add(Part part, double us) noexcept;
  /// Share of one core [%].
  [[nodiscard]] double share(Part part) const noexcept;
  [[nodiscard]] double share() const noexcept;  ///< of all parts together
};

/// Messages of one topic.
struct Published {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  ///< of the payloads
  friend bool operator==(const Published&, const Published&) = default;
};

/// A station in virtual time: its own haptic thread's tick, the stages of its core and their messages, over the stream
/// of a SeenBody and with the scene's simulated hand. All parts run on the caller's thread, whose processor time is
/// measured; sockets and encryption are left out (receiving.h). The session time stands still while a stage runs, and
/// its result is handed over at once, so that a run's forces, surfaces and messages do not depend on the computer's
/// speed.
class BilledStation {
 public:
  /// Makes the surfaces of the scene's layers. `stream` must outlive this object.
  BilledStation(const scenes::Scene& scene, const SceneParts& parts, const BodyStream& stream);
  BilledStation(const BilledStation&) = delete;
  BilledStation& operator=(const BilledStation&) = delete;

  /// Runs `seconds` more of session time, and adds their cost to `cost`. `pace`: waited for before each tick, as the
  /// haptic thread does; nullptr: the ticks follow each other at once.
  void run(double seconds, StationCost& cost, TickTimer* pace = nullptr);

  /// Mean time of each effect in a tick with contact [us], in the scene's order.
  [[nodiscard]] std::vector<double> effects_us() const;
  /// Processor time of the layers' surfaces for viewers, once at the start [ms].
  [[nodiscard]] double start_ms() const noexcept { return start_ms_; }
  /// Messages since the start, by topic.
  [[nodiscard]] const std::map<std::string, Published>& published() const noexcept { return published_; }

 private:
  void start_surface_stage(const SceneParts& parts);
  void start_inside_stages();
  template <class Stage, class... Inputs>
  std::optional<typename Stage::Result> run_stage(core::VirtualDriver<Stage>& driver, Stage& stage, double& spent_us,
                                                  Inputs&&... inputs);
  void see(StationCost& cost);
  void detect(StationCost& cost);
  void look_inside(StationCost& cost);
  void run_effects(StationCost& cost);
  void serve(StationCost& cost);
  void publish_totals();
  void tick(StationCost& cost, TickTimer* pace);
  void publish(const wire::Message& message);

  scenes::Scene scene_;
  const BodyStream& stream_;
  LatestValue<loop::TouchableSurface> surfaces_;
  LatestValue<Point<HapticBase>> device_to_surface_;
  std::unique_ptr<TickRing> ticks_ = std::make_unique<TickRing>();
  core::BuiltEffects effects_;
  LatestValue<core::ToolAt> tool_;  // where the haptic thread's tick says that the tool is
  std::vector<core::VirtualDriver<core::EffectStage>> effect_drivers_;
  loop::HapticLoop loop_;
  std::unique_ptr<ports::Rig> rig_;
  HapticThread haptic_;  // never started: its ticks run on the caller's thread
  TelemetryPublisher telemetry_;
  std::optional<core::SurfaceStage> surface_stage_;  // nullopt: the scene's patient is a model
  core::VirtualDriver<core::SurfaceStage> surface_driver_;
  std::optional<core::CollisionStage> collision_;  // nullopt: the surface is evaluated in the tick
  core::VirtualDriver<core::CollisionStage> collision_driver_;
  std::optional<loop::TouchableSurface> to_collision_;  // a surface that the collision stage has not got
  std::optional<core::UltrasoundStage> ultrasound_;     // nullopt: the hand holds no probe
  core::VirtualDriver<core::UltrasoundStage> ultrasound_driver_;
  std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera_;
  std::map<std::string, Published> published_;
  loop::ObjectPlacements objects_{};
  SessionTime now_ = BodyStream::kBegin;
  std::uint64_t ticked_ = 0;
  std::size_t next_image_ = 0;
  double start_ms_ = 0.0;
  bool device_known_ = false;  // there was a tick
  bool tool_known_ = false;
};

}  // namespace telepalp::station
