#pragma once

#include <optional>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/loop/attitude_gate.h"
#include "haptic_station/loop/body_frame.h"
#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/device_gate.h"
#include "haptic_station/loop/loop_delay.h"
#include "haptic_station/loop/tick.h"
#include "haptic_station/loop/workspace_indexing.h"
#include "haptic_station/surface/touch/touch.h"
#include "haptic_station/tracking/attitude_estimate.h"
#include "haptic_station/tracking/hand_estimate.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::loop {

/// One tick of the haptic station: sense, decide, act. Connects surface::Touch, the estimate of the hand and the
/// encountered controller. It uses no clock, no thread and no device, so that the same tick runs live at 2 kHz, in
/// virtual time and in a test. Owner: the haptic thread. Nothing here allocates, locks, throws or makes a system call.
class HapticLoop {
 public:
  struct Settings {
    surface::TouchSettings touch;
    tracking::HandEstimateSettings hand;
  };

  /// The displayed skin follows the newest image as fast as the stiffest effect allows.
  HapticLoop(const Settings& settings, const control::EncounteredController& controller) noexcept
      : HapticLoop(settings, controller, surface::follow_limits(controller.stiffest_N_per_m())) {}
  HapticLoop(const Settings& settings, const control::EncounteredController& controller,
             const surface::FollowLimits& follow) noexcept
      : touch_(settings.touch, follow),
        body_(follow),
        hand_(settings.hand),
        controller_(controller),
        indexing_(controller.settings().indexing) {}

  /// Runs one tick: takes what came, senses, decides. The caller applies the force. `given.now` may stand still or go
  /// back by up to 50 ms. A larger step back means that another session has begun: surface and hand samples are then
  /// discarded, and the controller gives no force (phase Released) until new ones come.
  [[nodiscard]] TickOut tick(const TickIn& given) noexcept;

  /// The delay compensation of the last tick. The caller sets its time stamp.
  [[nodiscard]] Compensation compensation() const noexcept;

  /// For each object inside the body: the displacement at which it is displayed, its standard deviation, and whether
  /// the camera sees the skin above the object.
  [[nodiscard]] ObjectPlacements objects() const noexcept;

  /// Converts a position from the device's own frame to H, with the last tick's shift. Without workspace indexing the
  /// two frames are the same.
  [[nodiscard]] Point<HapticBase> in_patient_frame(const Point<HapticBase>& at) const noexcept {
    return {at.m + indexing_.now().shift.v};
  }
  /// Converts `contact` from H to the device's own frame, for devices and simulated persons.
  [[nodiscard]] ports::SurfaceContact in_device_frame(ports::SurfaceContact contact) const noexcept {
    contact.proxy.m -= indexing_.now().shift.v;
    return contact;
  }

  [[nodiscard]] const control::EncounteredController& controller() const noexcept { return controller_; }
  [[nodiscard]] control::EncounteredController& controller() noexcept { return controller_; }

 private:
  void adopt(const TouchableSurface& surface, SessionTime now) noexcept;
  void hand_sampled(const ports::HandSample& sample) noexcept;
  void begin_new_time_line() noexcept;
  [[nodiscard]] ports::SurfaceContact contact_of(const surface::TouchSample& touch) const noexcept;
  [[nodiscard]] TickSample sample_of(const control::ControlInput& in, const control::ControlOutput& out) const noexcept;

  /// The depth camera in the haptic base's frame, both ways.
  struct CameraPlace {
    Transform<HapticBase, DepthCamera> haptic_from_camera;
    Transform<DepthCamera, HapticBase> camera_from_haptic;
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< rotation of `camera_from_haptic`
  };
  /// The newest sample of the hand that the estimate used.
  struct NewestHand {
    Point<HapticBase> at;  ///< as measured, without prediction
    SessionTime sampled{};
    std::optional<double> wait_at_m;
  };
  /// What the last tick sensed and decided.
  struct LastTick {
    surface::TouchSample touch;
    tracking::HandPrediction hand;
    control::ControlOutput out;
    SessionTime at{};
  };

  DeviceGate device_gate_;
  AttitudeGate attitude_gate_;
  LoopDelay loop_delay_;
  surface::Touch touch_;
  BodyFrame body_;
  tracking::HandEstimate hand_;
  tracking::AttitudeEstimate attitude_;
  control::EncounteredController controller_;
  WorkspaceIndexing indexing_;
  /// True once workspace indexing has shifted the body in this contact. The motion of the anchor (the skin point from
  /// which indentation counts) is then ignored until the contact ends.
  bool anchor_lost_ = false;
  CameraPlace camera_;
  NewestHand newest_hand_;
  LastTick last_;
  SessionTime surface_captured_{};
  bool has_surface_ = false;
  bool ticked_ = false;
};

}  // namespace telepalp::loop
