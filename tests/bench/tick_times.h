#pragma once

#include "haptic_station/device/trial.h"
#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/loop/tick.h"
#include "tests/bench/distribution.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::bench {

/// Times of ticks [us].
struct TickTimes {
  Distribution all;        ///< wall time
  Distribution processor;  ///< processor time, without other programs on the same core
  Distribution contact;    ///< wall time of the ticks in contact
};

/// Times the live loop's whole tick, from proxy to limiter, over a snapshot of a level skin that a noisy camera sees,
/// while a simulated hand does `trial`.
[[nodiscard]] TickTimes measure_ticks(const effects::EffectBank& bank, device::Trial trial, double seconds);

}  // namespace telepalp::bench
