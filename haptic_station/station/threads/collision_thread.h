#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "haptic_station/core/collision_stage.h"
#include "proto/words/latest_value.h"

namespace telepalp::station {

class JournalThread;

/// Drives the collision stage by the hand-offs of the threads. Owner: one thread, or one run in virtual time.
class CollisionDetection {
 public:
  /// One step at `now`, 10 ms after the last: takes the newest surface and device position, and hands on the plane.
  /// `journal`: keeps the run; nullptr: none.
  void detect(LatestValue<loop::TouchableSurface>& from_surface, LatestValue<Point<HapticBase>>& device,
              LatestValue<loop::TouchableSurface>& to_haptic, const std::function<SessionTime()>& now,
              JournalThread* journal = nullptr);

 private:
  core::CollisionStage stage_;
};

/// The collision thread: runs the collision stage 100 times a second, and hands its planes to the haptic thread.
class CollisionThread {
 public:
  CollisionThread(LatestValue<loop::TouchableSurface>& from_surface, LatestValue<Point<HapticBase>>& device,
                  LatestValue<loop::TouchableSurface>& to_haptic, std::function<SessionTime()> now,
                  JournalThread* journal = nullptr);
  ~CollisionThread();
  CollisionThread(const CollisionThread&) = delete;
  CollisionThread& operator=(const CollisionThread&) = delete;

 private:
  void run();

  LatestValue<loop::TouchableSurface>& from_surface_;  // written by: surface thread
  LatestValue<Point<HapticBase>>& device_;             // written by: haptic thread
  LatestValue<loop::TouchableSurface>& to_haptic_;     // read by: haptic thread
  std::function<SessionTime()> now_;
  JournalThread* journal_;        // nullptr: no journal is written
  CollisionDetection detection_;  // owner: this thread
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace telepalp::station
