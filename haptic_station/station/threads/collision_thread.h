#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/surface/touch/touch.h"
#include "proto/words/latest_value.h"

namespace telepalp::station {

/// The plane of the surface point nearest to the device, for a surface that the haptic thread cannot evaluate. Owner:
/// one thread, or one run in virtual time.
class CollisionDetection {
 public:
  /// One step at `now`, 10 ms after the last: takes the newest surface and device position, and hands on the plane.
  void detect(LatestValue<loop::TouchableSurface>& from_surface, LatestValue<Point<HapticBase>>& device,
              LatestValue<loop::TouchableSurface>& to_haptic, SessionTime now);

 private:
  surface::Touch touch_;
  SessionTime latest_{};  // last reading of the session clock
};

/// The collision detection of paper S1 (docs/sources.md): 100 times a second it finds the surface point nearest to the
/// device, on a surface whose evaluation is too slow or not real-time safe for the haptic thread, and hands the tangent
/// plane at this point to the haptic thread. It runs only if the surface settings name a surface of this kind.
class CollisionThread {
 public:
  CollisionThread(LatestValue<loop::TouchableSurface>& from_surface, LatestValue<Point<HapticBase>>& device,
                  LatestValue<loop::TouchableSurface>& to_haptic, std::function<SessionTime()> now);
  ~CollisionThread();
  CollisionThread(const CollisionThread&) = delete;
  CollisionThread& operator=(const CollisionThread&) = delete;

 private:
  void run();

  LatestValue<loop::TouchableSurface>& from_surface_;  // written by: surface thread
  LatestValue<Point<HapticBase>>& device_;             // written by: haptic thread
  LatestValue<loop::TouchableSurface>& to_haptic_;     // read by: haptic thread
  std::function<SessionTime()> now_;
  CollisionDetection detection_;  // owner: this thread
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace telepalp::station
