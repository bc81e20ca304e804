#include "proto/wire/clock_sync.h"

#include <algorithm>
#include <iterator>

#include "proto/words/demand.h"

namespace telepalp::wire {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kWindow = 32;    // half a minute of probes: two crystals drift apart by a millisecond at most
constexpr Nanoseconds kStep = 1s;      // beyond any network delay: another session, or a machine that slept
constexpr std::size_t kAgreeing = 3;   // samples that must contradict the old ones before these are dropped
constexpr double kDrift = 200e-6;      // two crystals of 100 ppm, in opposite directions
constexpr Nanoseconds kSlack = 100us;  // of the stamps themselves: scheduling between stamp and socket

/// True when no offset lies within both samples' bounds, even allowing for drift: the clocks have jumped between them.
bool contradict(const ClockSample& a, const ClockSample& b) noexcept {
  const Nanoseconds apart = b.heard - a.heard;
  const Nanoseconds drift{static_cast<std::int64_t>(kDrift * static_cast<double>(apart.count()))};
  const Nanoseconds difference = a.offset() - b.offset();
  return std::chrono::abs(difference) > a.round_trip() / 2 + b.round_trip() / 2 + std::chrono::abs(drift) + kSlack;
}

}  // namespace

const ClockSample& ClockSync::best() const noexcept {
  return *std::min_element(window_.begin(), window_.end(),
                           [](const ClockSample& a, const ClockSample& b) { return a.round_trip() < b.round_trip(); });
}

Nanoseconds ClockSync::uncertainty() const noexcept {
  return window_.empty() ? Nanoseconds::max() : best().round_trip() / 2;
}

bool ClockSync::add(const ClockSample& sample) {
  if (sample.heard < sample.asked || sample.replied < sample.received || sample.round_trip() < 0ns) return false;
  window_.push_back(sample);
  if (window_.size() > kWindow) window_.pop_front();
  drop_what_a_jump_has_outdated();
  follow(best().offset(), sample.heard);
  return true;
}

void ClockSync::drop_what_a_jump_has_outdated() {
  if (window_.size() <= kAgreeing) return;
  const auto newest = window_.end() - static_cast<std::ptrdiff_t>(kAgreeing);
  const ClockSample& old_best =
      *std::min_element(window_.begin(), newest,
                        [](const ClockSample& a, const ClockSample& b) { return a.round_trip() < b.round_trip(); });
  if (std::all_of(newest, window_.end(), [&](const ClockSample& sample) { return contradict(old_best, sample); }))
    window_.erase(window_.begin(), newest);
}

void ClockSync::follow(Nanoseconds estimate, Nanoseconds local_now) noexcept {
  const bool is_step = !given_ || std::chrono::abs(estimate - *given_) >= kStep;
  if (given_ && is_step) ++steps_;
  const Nanoseconds lowest = is_step ? estimate : *given_ - std::max(0ns, (local_now - given_at_) / 2);
  given_ = std::max(estimate, lowest);
  given_at_ = local_now;
}

}  // namespace telepalp::wire
