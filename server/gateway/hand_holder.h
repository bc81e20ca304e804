#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "messages/viewer.pb.h"
#include "proto/words/time.h"

namespace telepalp::gateway {

/// Decides which viewer controls the hand of a station with `--tracker browser`. The first viewer that moves its hand
/// (/viewer/hand) gets control and keeps it, even without messages, until it lets go (gives up control), disconnects,
/// or hands control over to another viewer. Other viewers request control by moving their hands. Pure; owner: the
/// server's network thread.
class HandHolder {
 public:
  /// Call it when `viewer` moves its hand. True: the viewer has control, and the message may go to the station.
  [[nodiscard]] bool moves(std::uint64_t viewer, SessionTime now);

  /// Call it when `viewer` lets go or disconnects. Another viewer gets control when it next moves its hand.
  void let_go(std::uint64_t viewer);

  /// `viewer` hands over control to viewer `to`, which accepts by requesting it. False: `viewer` has no control, or
  /// `to` has not requested it in the last 3 s; nothing changes.
  [[nodiscard]] bool hand_over(std::uint64_t viewer, std::uint64_t to, SessionTime now);

  /// True if `viewer` may re-arm the station: it has control, or no viewer has.
  [[nodiscard]] bool may_rearm(std::uint64_t viewer) const noexcept { return holder_ == 0 || holder_ == viewer; }

  /// The controlling and the requesting viewers, if they changed since the last call; otherwise nullopt.
  [[nodiscard]] std::optional<msg::HandHolder> news(SessionTime now);

 private:
  std::uint64_t holder_ = 0;                     // 0: no viewer
  std::map<std::uint64_t, SessionTime> asking_;  // key: viewer; value: when it last moved its hand
  msg::HandHolder published_;
};

}  // namespace telepalp::gateway
