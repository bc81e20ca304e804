#include "server/gateway/hand_holder.h"

namespace telepalp::gateway {
namespace {

constexpr std::chrono::seconds kStillAsking{3};
constexpr std::size_t kMaxAsking = 64;  // the gateway has no more connections

}  // namespace

bool HandHolder::moves(std::uint64_t viewer, SessionTime now, bool is_own) {
  if (holder_ == viewer && !is_own && !handed_) holder_ = 0;
  if (holder_ == 0 && is_own) {
    holder_ = viewer;
    handed_ = false;
  }
  if (holder_ == viewer) {
    moved_ = now;
    asking_.erase(viewer);
  } else if (asking_.size() < kMaxAsking || asking_.contains(viewer)) {
    asking_[viewer] = now;
  }
  return holder_ == viewer;
}

void HandHolder::let_go(std::uint64_t viewer) {
  asking_.erase(viewer);
  if (holder_ == viewer) holder_ = 0;
}

void HandHolder::end_if_silent(SessionTime now) {
  if (holder_ != 0 && now - moved_ > kSilent) let_go(holder_);
}

bool HandHolder::hand_over(std::uint64_t viewer, std::uint64_t to, SessionTime now) {
  const auto asked = asking_.find(to);
  if (holder_ != viewer || asked == asking_.end() || now - asked->second > kStillAsking) return false;
  asking_.erase(asked);
  holder_ = to;
  handed_ = true;
  moved_ = now;
  return true;
}

std::optional<msg::HandHolder> HandHolder::news(SessionTime now) {
  std::erase_if(asking_, [&](const auto& one) { return now - one.second > kStillAsking; });
  msg::HandHolder holder;
  holder.set_stamp_ns(published_.stamp_ns());
  holder.set_viewer(holder_);
  for (const auto& [viewer, moved] : asking_) holder.add_asking(viewer);
  if (holder.SerializeAsString() == published_.SerializeAsString()) return std::nullopt;
  holder.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  published_ = holder;
  return holder;
}

}  // namespace telepalp::gateway
