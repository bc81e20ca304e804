#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "haptic_station/core/collision_stage.h"
#include "proto/words/latest_value.h"

namespace telepalp::station {

class JournalThread;

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
  void detect();

  LatestValue<loop::TouchableSurface>& from_surface_;  // written by: surface thread
  LatestValue<Point<HapticBase>>& device_;             // written by: haptic thread
  LatestValue<loop::TouchableSurface>& to_haptic_;     // read by: haptic thread
  std::function<SessionTime()> now_;
  JournalThread* journal_;      // nullptr: no journal is written
  core::CollisionStage stage_;  // owner: this thread
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace telepalp::station
