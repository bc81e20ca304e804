#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "messages/viewer.pb.h"
#include "proto/words/time.h"

namespace telepalp::gateway {

/// Decides which viewer controls the hand of a station with `--tracker browser`. The first viewer that moves its hand
/// (/viewer/hand) gets control and keeps it until it lets go (gives up control), disconnects, sends nothing for
/// kSilent, or hands control over to another viewer. Other viewers request control by moving their hands. Pure; owner:
/// the server's network thread.
class HandHolder {
 public:
  static constexpr std::chrono::seconds kSilent{2};

  /// Call it when `viewer` moves its hand. True: the viewer has control, and the message may go to the station.
  /// `is_own`: the station belongs to the viewer's doctor, or to nobody. If it is false, the viewer has control only if
  /// another viewer has handed it over; else the call requests control.
  [[nodiscard]] bool moves(std::uint64_t viewer, SessionTime now, bool is_own);

  /// Call it when `viewer` lets go or disconnects. Another viewer gets control when it next moves its hand.
  void let_go(std::uint64_t viewer);

  /// Ends the control of a viewer that has sent nothing for kSilent. Call it several times a second.
  void end_if_silent(SessionTime now);
  [[nodiscard]] bool holds(std::uint64_t viewer) const noexcept { return holder_ == viewer; }

  /// `viewer` hands over control to viewer `to`, which accepts by requesting it. False: `viewer` has no control, or
  /// `to` has not requested it in the last 3 s; nothing changes.
  [[nodiscard]] bool hand_over(std::uint64_t viewer, std::uint64_t to, SessionTime now);

  /// True if `viewer` may re-arm the station, or accept an object as skin: it has control, or no viewer has and the
  /// station is its own doctor's (`is_own`).
  [[nodiscard]] bool may_command(std::uint64_t viewer, bool is_own) const noexcept {
    return holder_ == viewer ? is_own || handed_ : holder_ == 0 && is_own;
  }

  /// The controlling and the requesting viewers, if they changed since the last call; otherwise nullopt.
  [[nodiscard]] std::optional<msg::HandHolder> news(SessionTime now);

 private:
  std::uint64_t holder_ = 0;                     // 0: no viewer
  bool handed_ = false;                          // the holder got control from another viewer
  SessionTime moved_{};                          // when the holder last sent its hand, or was given control
  std::map<std::uint64_t, SessionTime> asking_;  // key: viewer; value: when it last moved its hand
  msg::HandHolder published_;
};

}  // namespace telepalp::gateway
