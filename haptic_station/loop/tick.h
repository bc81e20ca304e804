#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "haptic_station/control/encountered_controller.h"
#include "haptic_station/loop/tick_sample.h"
#include "haptic_station/ports/readings.h"
#include "haptic_station/ports/surface_contact.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"
#include "proto/words/wrench.h"

namespace telepalp::loop {

inline constexpr std::chrono::microseconds kTickPeriod{500};  // 2 kHz: paper S1 (docs/sources.md) II.D

/// A surface and its place relative to the haptic device. The surface thread hands it to the haptic thread.
struct TouchableSurface {
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;  // shared: the hand-off between the threads owns it, too
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  std::uint64_t number = 0;  ///< counted from 1 by the stage that made it; 0: no stage made it
};

/// Everything that one tick depends on, besides the loop's own state. The same values give the same force, to the last
/// bit, whether a thread, virtual time or a test supplies them.
struct TickIn {
  SessionTime now;
  double dt_s = 0.0;  ///< time since the last tick, for which the last force was applied [s]
  double missed_s = 0.0;  ///< the part of dt_s before the period that ends now: the time of the ticks that were missed
  /// The newest sample of the hand, in the device's own frame, if one came since the last tick. A sample stamped more
  /// than 50 ms after the last tick is dropped.
  std::optional<ports::HandSample> hand = {};
  ports::DeviceReading reading = {};  ///< in the device's own frame
  /// A newer surface, if there is one. Its snapshot must stay alive until a later tick gets another one.
  const TouchableSurface* surface = nullptr;
  bool rearm = false;  ///< an operator asks to re-arm after a fault
};

/// The result of one tick, in H: force and torque to apply until the next tick, after the limiter, and the values that
/// telemetry publishes, without the tick's number and times. Workspace indexing moves H relative to the device's frame.
struct TickOut {
  Force<HapticBase> force;
  Torque<HapticBase> torque;
  ports::SurfaceContact contact;
  control::ControlOutput control;
  TickSample sample;
};

}  // namespace telepalp::loop
