#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "messages/viewer.pb.h"
#include "proto/words/time.h"

namespace telepalp::server {

/// Which viewer holds the hand. The first that moves one holds it, through any silence, until it lets go or is gone;
/// the others ask by moving theirs. Pure; owner: the server's network thread.
class HandHolder {
 public:
  /// `viewer` moved its hand at `now`. True: it holds the hand, and the station may follow.
  [[nodiscard]] bool moves(std::uint64_t viewer, SessionTime now);

  /// `viewer` gives the hand up, or is gone. No other viewer gets it before it moves its hand again.
  void let_go(std::uint64_t viewer);

  /// Who holds the hand and who asks, when that is not what was last told; nullopt else.
  [[nodiscard]] std::optional<msg::HandHolder> news(SessionTime now);

 private:
  std::uint64_t holder_ = 0;                     // 0: nobody
  std::map<std::uint64_t, SessionTime> asking_;  // by viewer: when it last moved its hand
  msg::HandHolder told_;
};

}  // namespace telepalp::server
