#include "server/access/touch_lease.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace telepalp::access {
namespace {

constexpr std::size_t kMostWaiting = 32;

}  // namespace

bool TouchLease::take(const Station& station, TimePoint now) {
  const bool is_free = !held_ || now > held_->until;
  const bool comes_back =
      (held_ && held_->peer == 0 && held_->serial == station.serial) || older_connection(station).has_value();
  const bool is_left_to = held_ && held_->peer == 0 && held_->serial.empty() && offered_to(now) == station.name;
  const bool has_it = held_ && held_->peer == station.peer && !is_free;
  if (!is_free && !comes_back && !is_left_to && !has_it) {
    wait(station.run);
    return false;
  }
  if (!comes_back && !has_it && waits(station.run) && !station.accepts) return false;
  const bool same_holder = !is_free && !is_left_to;
  hold(station, same_holder ? held_->offer : std::nullopt, now);
  return true;
}

std::optional<std::uint64_t> TouchLease::older_connection(const Station& station) const {
  const bool same_run = held_ && station.run != 0 && held_->run == station.run && held_->serial == station.serial;
  if (!same_run || held_->peer == 0 || held_->peer == station.peer) return std::nullopt;
  return held_->peer;
}

void TouchLease::hold(const Station& station, std::optional<Offer> offer, TimePoint now) {
  std::erase(waiting_, station.run);
  held_ = Held{.peer = station.peer,
               .run = station.run,
               .serial = station.serial,
               .name = station.name,
               .until = now + kLease,
               .offer = std::move(offer)};
}

bool TouchLease::waits(std::uint64_t run) const {
  return run != 0 && std::find(waiting_.begin(), waiting_.end(), run) != waiting_.end();
}

void TouchLease::wait(std::uint64_t run) {
  if (run == 0 || waits(run)) return;
  if (waiting_.size() >= kMostWaiting) waiting_.pop_front();
  waiting_.push_back(run);
}

bool TouchLease::must_accept(std::uint64_t run, TimePoint now) const { return waits(run) && !holder(now); }

std::optional<std::string> TouchLease::take_away(TimePoint now) {
  const std::optional<std::string> before = holder(now);
  if (before) wait(held_->run);
  held_.reset();
  return before;
}

std::string TouchLease::kept() const {
  std::ostringstream text;
  if (held_ && !held_->serial.empty()) text << held_->serial << ' ' << held_->name;
  text << ';';
  for (const std::uint64_t run : waiting_) text << ' ' << run;
  return text.str();
}

void TouchLease::restore(const std::string& kept, TimePoint now) {
  const std::size_t end = kept.find(';');
  if (end == std::string::npos) return;
  std::istringstream holder(kept.substr(0, end)), runs(kept.substr(end + 1));
  Station station;
  if (holder >> station.serial >> station.name) hold(station, std::nullopt, now);
  for (std::uint64_t run = 0; runs >> run;) wait(run);
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

std::optional<std::uint64_t> TouchLease::accept(const Station& station, TimePoint now) {
  if (offered_to(now) != station.name) return std::nullopt;
  const std::uint64_t before = held_->peer;
  hold(station, std::nullopt, now);
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
