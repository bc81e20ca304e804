#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "haptic_station/core/tick_stage.h"
#include "tests/bench/hand/feed.h"
#include "tests/bench/hand/patient.h"
#include "tests/bench/hand/person.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::bench::hand {

inline constexpr double kSkin_N_per_m = 500.0;
inline constexpr double kFrom_s = 14.0, kUntil_s = 54.0;  ///< the time that is judged; predictions have learned by then
inline constexpr double kDepth_m = 0.003;                 ///< of a hand below the skin at full exhale

/// Settings of the station's loop with a linear skin, and faults other than the surface's.
struct StationSettings {
  effects::EffectBank effects;
  control::ControlSettings control;
  core::TickStage::Settings loop;
  double extra_delay_s = 0.0;  ///< extra delay of the snapshots, in addition to the feed's link
  std::uint64_t seed = 1;
  std::function<bool(double time_s)> tracker_silent = [](double) { return false; };
  std::function<void(double time_s, ports::DeviceReading&)> spoil = [](double, ports::DeviceReading&) {};
};
/// The height of a device that comes down from 60 mm above the skin, and from 2.5 s on is `depth_m` below it [m].
[[nodiscard]] double reaching_m(double time_s, double depth_m) noexcept;

[[nodiscard]] StationSettings with_skin(effects::SkinAnchor anchor, double stiffness_N_per_m = kSkin_N_per_m);

/// One tick, against the true skin of the same instant. All vectors in H.
struct Tick {
  double time_s = 0.0;
  Eigen::Vector3d device_m = Eigen::Vector3d::Zero();  ///< true position of the device at the tick's beginning
  Eigen::Vector3d hand_m = Eigen::Vector3d::Zero();    ///< true position of the hand
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();   ///< movement since the previous tick
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();   ///< force for the next tick
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();   ///< normal of the true skin
  double true_depth_m = 0.0;                           ///< depth of the device below the true skin; negative: outside
  bool true_known = false;                             ///< false: the device is far from the true skin
  bool displayed = false;                              ///< true: the controller displays the skin
  double surface_age_s = 0.0;                          ///< time since the capture of the touched surface
  control::ControlOutput control = {};

  [[nodiscard]] double pushed_N() const noexcept { return force_N.dot(normal); }
  /// The force that the true skin would give, at most the device's peak.
  [[nodiscard]] double law_N(double stiffness_N_per_m = kSkin_N_per_m) const noexcept {
    return true_known && true_depth_m > 0.0 ? std::min(10.0, stiffness_N_per_m * true_depth_m) : 0.0;
  }
};

/// Sets the normal and the depth of `tick`, and whether they are known: those of its device at the skin `skin`.
void touch(const capture::TrueSurface& skin, const Transform<HapticBase, DepthCamera>& haptic_from_camera, Tick& tick);

/// One station's tick with a person at it, fed by a feed that it may share with others.
class BenchStation {
 public:
  BenchStation(const StationSettings& settings, const Transform<HapticBase, DepthCamera>& haptic_from_camera,
               std::unique_ptr<Person> person);

  void receive(std::shared_ptr<const surface::SurfaceSnapshot> snapshot, double time_s);
  /// One tick. `truth`: the true surface of this instant.
  [[nodiscard]] Tick step(double time_s, const capture::TrueSurface& truth);
  [[nodiscard]] Point<DepthCamera> device_camera() const { return camera_from_haptic_ * person_->device(); }
  [[nodiscard]] const core::TickStage& ticks() const noexcept { return ticks_; }

 private:
  class HeldRig;
  struct Arriving {
    double at_s;
    std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
  };
  StationSettings settings_;
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  Transform<DepthCamera, HapticBase> camera_from_haptic_;
  std::unique_ptr<Person> person_;
  core::TickStage ticks_;
  device::SimulatedTracker tracker_;
  std::deque<Arriving> arriving_;
  loop::TouchableSurface touched_;
  Eigen::Vector3d before_m_;
};

/// Runs `station` on `feed` for `seconds` and calls `judge` after each tick.
void run(Feed& feed, BenchStation& station, double seconds, const std::function<void(const Tick&)>& judge);

/// Runs `station` on `feed`, and calls `judge` after each tick until `judge` returns false.
void run_while(Feed& feed, BenchStation& station, const std::function<bool(const Tick&)>& judge);

/// Smooth from 0 to 1 while `x` goes from 0 to 1.
[[nodiscard]] double eased(double x) noexcept;

}  // namespace telepalp::bench::hand
