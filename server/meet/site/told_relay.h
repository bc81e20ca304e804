#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "messages/control.pb.h"
#include "messages/meet.pb.h"
#include "proto/words/repeats/said_once.h"

namespace telepalp::meet {

/// The relay of which the meeting point has told a site, with the newest credentials. A relay to which nothing may be
/// sent (ice::read_relay()) is not passed on to callers, and is said once.
class ToldRelay {
 public:
  explicit ToldRelay(std::function<void(const std::string&)> say) : say_(std::move(say)) {}

  void heard(const msg::MeetRelay& told);
  /// For callers; empty: the meeting point named none that may be used.
  [[nodiscard]] const std::vector<msg::IceRelay>& relays() const noexcept { return relays_; }

 private:
  std::function<void(const std::string&)> say_;
  std::vector<msg::IceRelay> relays_;
  SaidOnce said_;
};

}  // namespace telepalp::meet
