#include "server/access/touch_lease.h"

namespace telepalp::access {

bool TouchLease::take(std::uint64_t peer, const std::string& serial, const std::string& name, TimePoint now) {
  const bool is_free = !held_ || now > held_->until;
  const bool comes_back = held_ && held_->peer == 0 && held_->serial == serial;
  if (!is_free && !comes_back && held_->peer != peer) return false;
  held_ = Held{.peer = peer, .serial = serial, .name = name, .until = now + kLease};
  return true;
}

bool TouchLease::renew(std::uint64_t peer, TimePoint now) {
  if (!held_ || held_->peer != peer) return false;
  held_->until = now + kLease;
  return true;
}

void TouchLease::leave(std::uint64_t peer, bool on_purpose, TimePoint now) {
  if (!held_ || held_->peer != peer) return;
  if (on_purpose) return held_.reset();
  held_->peer = 0;
  held_->until = now + kLease;
}

std::optional<std::string> TouchLease::holder(TimePoint now) const {
  if (!held_ || now > held_->until) return std::nullopt;
  return held_->name;
}

}  // namespace telepalp::access
