#pragma once

#include "haptic_station/device/trial.h"
#include "haptic_station/effects/effect_bank.h"
#include "tests/bench/distribution.h"

namespace telepalp::bench {

/// Times of ticks [us].
struct TickTimes {
  Distribution all;
  Distribution processor;  ///< processor time, without other programs on the same core
  Distribution contact;    ///< of the ticks in contact
};

/// The live loop's whole tick, from proxy to limiter, over a real snapshot of a level skin, while a hand does `trial`.
[[nodiscard]] TickTimes measure_ticks(const effects::EffectBank& bank, device::Trial trial, double seconds);

}  // namespace telepalp::bench
