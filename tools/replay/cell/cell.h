#pragma once

#include <map>
#include <vector>

#include "tools/replay/cell/frame_sender.h"
#include "tools/replay/cell/true_skin.h"

namespace telepalp::replay {

/// Counters of one run's frames. `offered`, `in_time` and `touched` count a frame once its deadline has passed, so that
/// frames on their way at the end do not count as lost.
struct FrameCounts {
  std::uint64_t offered = 0;      ///< offered to the link; none while the server is down
  std::uint64_t in_time = 0;      ///< depth and colour were complete by the deadline
  std::uint64_t touched = 0;      ///< became a surface for the haptic loop
  std::uint64_t undecodable = 0;  ///< arrived, but could not be decoded
  std::uint64_t offered_B = 0;    ///< size of all offered frames
};

/// One run of the source over one network: the server's sender, the network and the station, in virtual time. Cells
/// share no state that one of them writes, so they may run on different threads. Pure if `publish` and `wires` are.
class Cell {
 public:
  /// `truth`: the source's true skin; empty for a recording. `tape`: how the frames are encoded. `wires`: the network
  /// that `scenario` describes.
  Cell(const StationSetup& setup, const Scenario& scenario, const TapeSettings& tape, TruthAt truth, Publish publish,
       Wires wires);

  /// Runs all ticks before `until`. `frames`: the frames that were captured from the last call's `until` on
  /// and before this call's `until`. Appends a record of each tick to `ticks`.
  void run_until(SessionTime until, const TapeFrames& frames, std::vector<TickRecord>& ticks);

  [[nodiscard]] FrameCounts frames() const noexcept;
  [[nodiscard]] const PathCounts& path() const noexcept { return path_.counts(); }
  /// Times of the frames whose surface the haptic loop got in the last run_until().
  [[nodiscard]] const std::vector<FrameTimes>& touchable() const noexcept { return touchable_; }
  [[nodiscard]] const Scenario& scenario() const noexcept { return scenario_; }
  [[nodiscard]] const Stopwatch& costs() const noexcept { return watch_; }

 private:
  void receive(const link::Frame& frame, SessionTime now);
  void count_complete(const link::Frame& frame, bool has_color, SessionTime now);
  [[nodiscard]] TickRecord tick();

  const StationSetup setup_;
  const Scenario scenario_;
  TruthAt truth_;
  Stopwatch watch_;
  FrameSender sender_;
  CameraPath path_;
  ReplayedStation station_;
  SessionTime now_ = kBegin;
  std::vector<SessionTime> in_time_;       ///< capture times
  std::vector<SessionTime> touched_;       ///< capture times
  std::map<std::uint32_t, int> complete_;  ///< how many images came in time; key: number of a recent frame
  std::vector<FrameTimes> touchable_;
};

}  // namespace telepalp::replay
