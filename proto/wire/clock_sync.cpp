#include "proto/wire/clock_sync.h"

#include <algorithm>
#include <iterator>

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kWindow = 32;  // half a minute of probes, one a second
constexpr Nanoseconds kStep = 1s;    // longer than any network delay: another session, or a computer that was suspended
constexpr std::size_t kAgreeing = 3;   // so many new samples must contradict the old ones before these are dropped
constexpr double kDrift = 200e-6;      // two crystals of 100 ppm that err in opposite directions
constexpr Nanoseconds kSlack = 100us;  // error of the stamps themselves, by scheduling between stamp and socket

/// True when no offset lies within both samples' bounds, even allowing for drift: the clocks have jumped between them.
bool contradict(const ClockSample& a, const ClockSample& b) noexcept {
  const Nanoseconds elapsed = b.heard - a.heard;
  const Nanoseconds drift{static_cast<std::int64_t>(kDrift * static_cast<double>(elapsed.count()))};
  const Nanoseconds difference = a.offset() - b.offset();
  return std::chrono::abs(difference) > a.round_trip() / 2 + b.round_trip() / 2 + std::chrono::abs(drift) + kSlack;
}

/// Bound on the error of `sample` at local time `now`: NTP's root distance without the terms of the root server.
Nanoseconds distance(const ClockSample& sample, Nanoseconds now) noexcept {
  const auto age = static_cast<double>((now - sample.heard).count());
  return sample.round_trip() / 2 + Nanoseconds{static_cast<std::int64_t>(kDrift * age)};
}

using Samples = std::deque<ClockSample>;
const ClockSample& nearest(Samples::const_iterator from, Samples::const_iterator to, Nanoseconds now) noexcept {
  return *std::min_element(
      from, to, [now](const ClockSample& a, const ClockSample& b) { return distance(a, now) < distance(b, now); });
}

}  // namespace

Nanoseconds ClockSync::uncertainty() const noexcept {
  if (window_.empty()) return Nanoseconds::max();
  const Nanoseconds now = window_.back().heard;
  return distance(nearest(window_.begin(), window_.end(), now), now);
}

bool ClockSync::add(const ClockSample& sample) {
  if (sample.heard < sample.asked || sample.replied < sample.received || sample.round_trip() < 0ns) return false;
  window_.push_back(sample);
  if (window_.size() > kWindow) window_.pop_front();
  drop_what_a_jump_has_outdated();
  follow(nearest(window_.begin(), window_.end(), sample.heard).offset(), sample.heard);
  return true;
}

void ClockSync::drop_what_a_jump_has_outdated() {
  if (window_.size() <= kAgreeing) return;
  const auto newest = window_.end() - static_cast<std::ptrdiff_t>(kAgreeing);
  const ClockSample& old_best = nearest(window_.begin(), newest, window_.back().heard);
  if (std::all_of(newest, window_.end(), [&](const ClockSample& sample) { return contradict(old_best, sample); }))
    window_.erase(window_.begin(), newest);
}

void ClockSync::follow(Nanoseconds estimate, Nanoseconds local_now) noexcept {
  const Nanoseconds current = given_ ? given_->at(local_now) : estimate;
  const bool is_step = std::chrono::abs(estimate - current) >= kStep;
  if (is_step) ++steps_;
  given_ = SlewedOffset{.target = estimate, .line_at_zero = (is_step ? estimate : current) + local_now / 2};
}

}  // namespace telepalp::wire
