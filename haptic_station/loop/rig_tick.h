#pragma once

#include "haptic_station/loop/haptic_loop.h"
#include "haptic_station/ports/rig.h"

namespace telepalp::loop {

/// The sequence of one tick at a rig: sample, decide, apply. `due`: the tick's time, surface and re-arm; the rig adds
/// the reading and the hand. `sampled(TickIn&)` is called before the loop decides: it may publish the reading, or
/// damage it in a test. `decided(const TickIn&, const TickOut&)` is called before the wrench is applied. Neither may
/// allocate, lock or throw on the haptic thread.
template <class Sampled, class Decided>
TickOut tick_at_rig(HapticLoop& loop, ports::Rig& rig, const TickIn& due, const Sampled& sampled,
                    const Decided& decided) noexcept {
  TickIn in = due;
  in.hand = rig.hand(due.now);
  in.reading = rig.read();
  sampled(in);
  TickOut out = loop.tick(in);
  decided(in, out);
  rig.apply({out.force, out.torque}, loop.in_device_frame(out.contact), due.dt_s);
  return out;
}

}  // namespace telepalp::loop
