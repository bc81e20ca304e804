#include "proto/wire/clock_sync.h"

#include <algorithm>
#include <iterator>

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kWindow = 60s;  // time over which the drift of the clocks counts as constant
constexpr std::size_t kMostSamples = 2000;
constexpr Nanoseconds kDriftFrom = 20s;  // a shorter window gives the drift too coarsely
constexpr Nanoseconds kStep = 1s;  // longer than any network delay: another session, or a computer that was suspended
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

Nanoseconds scaled(double factor, Nanoseconds span) noexcept {
  return Nanoseconds{static_cast<std::int64_t>(factor * static_cast<double>(span.count()))};
}

/// Bounds on the offset: the quickest request gives the upper one, the quickest reply the lower one.
struct Bounds {
  Nanoseconds above;
  Nanoseconds below;
  [[nodiscard]] Nanoseconds middle() const noexcept { return below + (above - below) / 2; }
};

/// The bounds at local time `now` from those samples that agree with the nearest one. `drift`: rate at which the offset
/// has changed since each sample [s/s]; `spread`: rate at which each bound widens with age [s/s].
Bounds bounds(Samples::const_iterator from, Samples::const_iterator to, Nanoseconds now, double drift,
              double spread) noexcept {
  const ClockSample& best = nearest(from, to, now);
  Bounds found{Nanoseconds::max(), Nanoseconds::min()};
  for (; from != to; ++from) {
    if (contradict(best, *from)) continue;
    const Nanoseconds age = now - from->heard;
    found.above = std::min(found.above, from->received - from->asked + scaled(drift + spread, age));
    found.below = std::max(found.below, from->replied - from->heard + scaled(drift - spread, age));
  }
  return found;
}

/// Drift of the clocks [s/s]: the change of the offset from the older half of the window to the newer half. Each half's
/// offset depends on the drift within it, so three rounds refine the drift.
double drift_of(const Samples& window) noexcept {
  if (window.back().heard - window.front().heard < kDriftFrom) return 0.0;
  const auto half = window.begin() + static_cast<std::ptrdiff_t>(window.size() / 2);
  const Nanoseconds older_end = std::prev(half)->heard;
  const Nanoseconds newer_end = window.back().heard;
  double drift = 0.0;
  for (int round = 0; round < 3; ++round) {
    const Nanoseconds older = bounds(window.begin(), half, older_end, drift, 0.0).middle();
    const Nanoseconds newer = bounds(half, window.end(), newer_end, drift, 0.0).middle();
    drift = static_cast<double>((newer - older).count()) / static_cast<double>((newer_end - older_end).count());
    drift = std::clamp(drift, -kDrift, kDrift);
  }
  return drift;
}

}  // namespace

Nanoseconds ClockSync::uncertainty(Nanoseconds local_now) const noexcept {
  if (window_.empty()) return Nanoseconds::max();
  const Bounds certain = bounds(window_.begin(), window_.end(), local_now, 0.0, kDrift);
  const Nanoseconds given = given_->at(local_now);
  return std::max({certain.above - given, given - certain.below, kSlack});
}

bool ClockSync::add(const ClockSample& sample) {
  if (sample.heard < sample.asked || sample.replied < sample.received || sample.round_trip() < 0ns) return false;
  window_.push_back(sample);
  while (window_.size() > kMostSamples || sample.heard - window_.front().heard > kWindow) window_.pop_front();
  drop_what_a_jump_has_outdated();
  follow(bounds(window_.begin(), window_.end(), sample.heard, drift_of(window_), 0.0).middle(), sample.heard);
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
  if (is_step) {
    ++steps_;
    stepped_ += estimate - current;
  }
  given_ = SlewedOffset{.target = estimate, .line_at_zero = (is_step ? estimate : current) + local_now / 2};
}

}  // namespace telepalp::wire
