#include "tests/bench/link/rival_flow.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kPacket_B = 1448;
constexpr double kCubicScale = 0.4;  ///< RFC 9438: C
constexpr double kCubicKeeps = 0.7;  ///< RFC 9438: beta
constexpr Nanoseconds kTimeout = 1s;
constexpr double kGains[] = {1.25, 0.75, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
constexpr double kHighGain = 2.89;

std::uint64_t sequence_of(const impaired::Packet& packet) {
  std::uint64_t sequence = 0;
  std::memcpy(&sequence, packet.bytes.data(), sizeof sequence);
  return sequence;
}

}  // namespace

std::string_view name(RivalKind kind) noexcept {
  switch (kind) {
    case RivalKind::Reno:
      return "Reno";
    case RivalKind::Cubic:
      return "Cubic";
    case RivalKind::Bbr:
      return "BBR";
  }
  return "";
}

void RivalFlow::arrived(const impaired::Packet& packet, Nanoseconds now) {
  received_B_ += static_cast<double>(packet.bytes.size());
  acks_.push_back({now + back_, sequence_of(packet)});
}

double RivalFlow::window_packets() const noexcept {
  if (kind_ != RivalKind::Bbr) return window_;
  if (probing_until_ > 0ns) return 4.0;
  if (best_rate_ <= 0.0) return 10.0;
  return std::max(4.0, (started_ ? 2.0 : kHighGain) * best_rate_ * to_seconds(least_));
}

bool RivalFlow::may_send(Nanoseconds now) const noexcept {
  return static_cast<double>(on_the_way_.size()) < window_packets() && now >= paced_until_;
}

void RivalFlow::step(Nanoseconds now, impaired::ImpairedLink& link) {
  while (!acks_.empty() && acks_.front().at <= now) {
    acknowledge(acks_.front().sequence, now);
    acks_.pop_front();
  }
  if (!on_the_way_.empty() && now - heard_at_ > kTimeout) {
    on_the_way_.clear();
    threshold_ = std::max(2.0, window_ / 2.0);
    window_ = 2.0;
    heard_at_ = now;
  }
  if (probing_until_ > 0ns && now > probing_until_) probing_until_ = 0ns;
  while (may_send(now)) {
    impaired::Packet packet{.bytes = std::vector<std::byte>(kPacket_B), .flow = flow_};
    std::memcpy(packet.bytes.data(), &next_, sizeof next_);
    if (on_the_way_.empty()) heard_at_ = now;
    on_the_way_.push_back({next_++, now, delivered_});
    link.send(now, std::move(packet));
    if (kind_ == RivalKind::Bbr && best_rate_ > 0.0) {
      const auto slot = static_cast<std::size_t>(now / std::max<Nanoseconds>(least_, 1ms)) % std::size(kGains);
      const double gain = started_ ? kGains[slot] : kHighGain;
      paced_until_ = std::max(paced_until_, now - 1ms) + from_seconds(1.0 / (gain * best_rate_));
    }
  }
}

/// The link keeps the packets' order, so all packets before an acknowledged one are lost.
void RivalFlow::acknowledge(std::uint64_t sequence, Nanoseconds now) {
  while (!on_the_way_.empty() && on_the_way_.front().sequence < sequence) {
    if (on_the_way_.front().sequence >= recover_until_) on_loss(now);
    on_the_way_.pop_front();
  }
  if (on_the_way_.empty() || on_the_way_.front().sequence != sequence) return;
  ++delivered_;
  heard_at_ = now;
  measure(on_the_way_.front(), now);
  on_the_way_.pop_front();
  grow(now);
}

void RivalFlow::measure(const Sent& sent, Nanoseconds now) {
  const Nanoseconds took = now - sent.at;
  round_trip_ = round_trip_ == 0ns ? took : round_trip_ + (took - round_trip_) / 8;
  if (least_ == 0ns || took <= least_) {
    least_ = took;
    least_at_ = now;
  }
  if (kind_ != RivalKind::Bbr) return;
  if (now - least_at_ > 10s) {
    probing_until_ = now + 200ms;
    least_at_ = now;
    least_ = took;
  }
  if (probing_until_ > 0ns) least_ = std::min(least_, took);
  const double rate = static_cast<double>(delivered_ - sent.delivered) / std::max(1e-6, to_seconds(took));
  while (!rates_.empty() && rates_.back().second <= rate) rates_.pop_back();
  rates_.emplace_back(now, rate);
  while (rates_.front().first < now - 10 * round_trip_) rates_.pop_front();
  best_rate_ = rates_.front().second;
  if (started_ || now - round_at_ < round_trip_) return;
  round_at_ = now;
  rounds_without_growth_ = best_rate_ < 1.25 * full_rate_ ? rounds_without_growth_ + 1 : 0;
  full_rate_ = std::max(full_rate_, best_rate_);
  started_ = rounds_without_growth_ >= 3;
}

void RivalFlow::on_loss(Nanoseconds now) {
  recover_until_ = next_;
  if (kind_ == RivalKind::Bbr) return;
  most_ = window_;
  window_ = std::max(2.0, window_ * (kind_ == RivalKind::Cubic ? kCubicKeeps : 0.5));
  threshold_ = window_;
  epoch_ = now;
}

double RivalFlow::cubic_target(Nanoseconds now) const noexcept {
  const double t = to_seconds(now - epoch_ + round_trip_);
  const double k = std::cbrt(most_ * (1.0 - kCubicKeeps) / kCubicScale);
  const double reno = most_ * kCubicKeeps + 0.53 * to_seconds(now - epoch_) / std::max(1e-3, to_seconds(round_trip_));
  return std::max(kCubicScale * std::pow(t - k, 3.0) + most_, reno);
}

void RivalFlow::grow(Nanoseconds now) {
  if (kind_ == RivalKind::Bbr) return;
  if (window_ < threshold_)
    window_ += 1.0;
  else if (kind_ == RivalKind::Reno)
    window_ += 1.0 / window_;
  else
    window_ += std::clamp((cubic_target(now) - window_) / window_, 0.0, 0.5);
}

}  // namespace telepalp::bench::link
