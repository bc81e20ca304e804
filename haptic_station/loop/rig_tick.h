#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/ports/rig.h"

namespace telepalp::loop {

/// After a longer interruption of the haptic thread, the loop and a simulation skip time instead of catching up.
inline constexpr std::uint64_t kMostCaughtUp = 20;

/// Time of a tick at `now`, before which `missed` ticks were missed.
[[nodiscard]] inline TickIn due_at(SessionTime now, std::uint64_t missed) noexcept {
  constexpr double kPeriod_s = std::chrono::duration<double>(kTickPeriod).count();
  const double missed_s = kPeriod_s * static_cast<double>(std::min(missed, kMostCaughtUp));
  return {.now = now, .dt_s = kPeriod_s + missed_s, .missed_s = missed_s};
}

/// The sequence of one tick at a rig: sample, decide, apply. `due`: the tick's time, surface and re-arm; the rig adds
/// the reading and the hand. `sampled(TickIn&)` is called before the loop decides: it may publish the reading, or
/// damage it in a test. `decided(const TickIn&, const TickOut&)` is called before the wrench is applied. Neither may
/// allocate, lock or throw on the haptic thread.
template <class Sampled, class Decided>
TickOut tick_at_rig(HapticLoop& loop, ports::Rig& rig, const TickIn& due, const Sampled& sampled,
                    const Decided& decided) noexcept {
  if (due.missed_s > 0.0) rig.catch_up(due.missed_s);
  TickIn in = due;
  in.hand = rig.hand(due.now);
  in.reading = rig.read();
  sampled(in);
  TickOut out = loop.tick(in);
  decided(in, out);
  rig.apply({out.force, out.torque}, loop.in_device_frame(out.contact), due.dt_s - due.missed_s);
  return out;
}

}  // namespace telepalp::loop
