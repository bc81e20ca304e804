#include "server/capture/pacing/frame_pacer.h"

#include <algorithm>
#include <thread>

namespace telepalp::capture {

FramePacer::FramePacer(wire::SessionClock clock, Nanoseconds period, bool paced) noexcept
    : clock_(clock), period_(period), paced_(paced) {}

std::optional<FrameSlot> FramePacer::next(Nanoseconds patience) {
  const SessionTime now = clock_.now();
  if (!start_) start_ = now;
  const auto due = [this] { return *start_ + period_ * static_cast<std::int64_t>(next_index_); };
  if (paced_) {
    const std::int64_t periods_gone = (now - *start_) / period_;
    next_index_ = std::max(next_index_, static_cast<std::uint64_t>(std::max<std::int64_t>(periods_gone, 0)));
    std::this_thread::sleep_until(clock_.steady(std::min(due(), now + patience)));
    if (due() > now + patience) return std::nullopt;
  }
  const FrameSlot slot{next_index_, due()};
  ++next_index_;
  return slot;
}

}  // namespace telepalp::capture
