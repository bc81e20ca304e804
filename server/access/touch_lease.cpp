#include "server/access/touch_lease.h"

namespace telepalp::access {

bool TouchLease::take(std::uint64_t peer, const std::string& serial, const std::string& name, TimePoint now) {
  const bool is_free = !held_ || now > held_->until;
  const bool comes_back = held_ && held_->peer == 0 && held_->serial == serial;
  const bool is_left_to = held_ && held_->peer == 0 && held_->serial.empty() && offered_to(now) == name;
  if (!is_free && !comes_back && !is_left_to && held_->peer != peer) return false;
  const bool same_holder = !is_free && !is_left_to;
  held_ = Held{.peer = peer,
               .serial = serial,
               .name = name,
               .until = now + kLease,
               .offer = same_holder ? held_->offer : std::nullopt};
  return true;
}

bool TouchLease::renew(std::uint64_t peer, TimePoint now) {
  if (!held_ || held_->peer != peer) return false;
  held_->until = now + kLease;
  return true;
}

void TouchLease::leave(std::uint64_t peer, bool on_purpose, TimePoint now) {
  if (!held_ || held_->peer != peer) return;
  if (on_purpose && !offered_to(now)) return held_.reset();
  if (on_purpose) held_->serial.clear();
  held_->peer = 0;
  held_->until = now + kLease;
}

bool TouchLease::offer(std::uint64_t peer, const std::string& to, TimePoint now) {
  if (!held_ || held_->peer != peer || now > held_->until) return false;
  held_->offer = to.empty() ? std::nullopt : std::optional(Offer{.to = to, .until = now + kOffer});
  return true;
}

std::optional<std::uint64_t> TouchLease::accept(std::uint64_t peer, const std::string& serial, const std::string& name,
                                                TimePoint now) {
  if (offered_to(now) != name) return std::nullopt;
  const std::uint64_t before = held_->peer;
  held_ = Held{.peer = peer, .serial = serial, .name = name, .until = now + kLease, .offer = std::nullopt};
  return before;
}

std::optional<std::string> TouchLease::holder(TimePoint now) const {
  if (!held_ || now > held_->until) return std::nullopt;
  return held_->name;
}

std::optional<std::string> TouchLease::offered_to(TimePoint now) const {
  if (!holder(now) || !held_->offer || now > held_->offer->until) return std::nullopt;
  return held_->offer->to;
}

}  // namespace telepalp::access
