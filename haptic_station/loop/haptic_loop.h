#pragma once

#include <memory>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/device_gate.h"
#include "haptic_station/loop/tick_sample.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/surface/touch/touch.h"
#include "haptic_station/tracking/hand_estimate.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::station {

/// A surface and where it lies before the haptic device. Handed from the surface thread to the haptic thread.
struct TouchableSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;  // shared: the hand-off's slot keeps it alive while in use
  Transform<HapticBase, DepthCamera> haptic_from_camera;
};

/// One tick of the haptic station: sense, decide, act. Joins the surface's touch, the hand's estimate and the
/// encountered controller; knows no clock, no thread and no device, so that the same tick runs live at 2 kHz, in
/// virtual time, and in a test. Owner: the haptic thread. Nothing here allocates, locks, throws or calls the system.
class HapticLoop {
 public:
  struct Settings {
    surface::TouchSettings touch;
    tracking::HandEstimateSettings hand;
  };

  HapticLoop(const Settings& settings, const control::EncounteredController& controller) noexcept
      : touch_(settings.touch), hand_(settings.hand), controller_(controller) {}

  /// A newer surface. Its snapshot must stay alive until the next adopt().
  void adopt(const TouchableSurface& surface, SessionTime now) noexcept;

  /// A sample of the hand tracker, at the tracker's own time. One from more than 50 ms after the last tick is dropped.
  void hand_sampled(SessionTime at, const Point<HapticBase>& hand) noexcept;

  /// An operator asks to re-arm; counts for the next tick.
  void rearm() noexcept { rearm_ = true; }

  /// Time may stand still or be late, but when it goes back by more than 50 ms, it is another session's: nothing of
  /// before is believed then, and the station lets go until surface and hand come again. The force to apply until the
  /// next tick [N, in H], already limited, and all that is told of the tick, but for its number and times.
  struct Act {
    Force<HapticBase> force;
    ports::SurfaceContact contact;
    control::ControlOutput control;
    TickSample told;
  };
  [[nodiscard]] Act tick(const ports::DeviceReading& device, SessionTime now, double dt_s) noexcept;

  /// What the last tick did about delay, but for its time.
  [[nodiscard]] Compensation compensation() const noexcept;

  [[nodiscard]] const control::EncounteredController& controller() const noexcept { return controller_; }
  [[nodiscard]] control::EncounteredController& controller() noexcept { return controller_; }

 private:
  void begin_new_time_line() noexcept;
  [[nodiscard]] ports::SurfaceContact contact_of(const surface::TouchSample& touch) const noexcept;
  [[nodiscard]] TickSample tell(const control::ControlInput& in, const control::ControlOutput& out) const noexcept;

  DeviceGate device_gate_;
  surface::Touch touch_;
  tracking::HandEstimate hand_;
  control::EncounteredController controller_;
  Transform<HapticBase, DepthCamera> haptic_from_camera_;
  Transform<DepthCamera, HapticBase> camera_from_haptic_;
  surface::TouchSample last_touch_;
  tracking::HandPrediction last_hand_;
  control::ControlOutput last_out_;
  Point<HapticBase> newest_hand_;  // as sampled
  SessionTime surface_captured_{};
  SessionTime hand_sampled_{};
  SessionTime last_tick_{};
  bool has_surface_ = false;
  bool ticked_ = false;
  bool rearm_ = false;
};

}  // namespace telepalp::station
