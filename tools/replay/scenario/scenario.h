#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "proto/impaired/impairment.h"

namespace telepalp::replay {

/// A span of time since the session's start.
struct Window {
  Nanoseconds from{0};
  Nanoseconds length{0};
  [[nodiscard]] bool contains(Nanoseconds at) const noexcept { return at >= from && at < from + length; }
};

[[nodiscard]] inline bool any_contains(const std::vector<Window>& windows, Nanoseconds at) noexcept {
  return std::any_of(windows.begin(), windows.end(), [at](const Window& window) { return window.contains(at); });
}

/// The station's clock is ahead of session time by `by` during the window; a negative `by`: behind it.
struct ClockStep {
  Window when;
  Nanoseconds by{0};
};

/// The device's encoder reports a position with an error of `off_m` along each axis during the window.
struct EncoderGlitch {
  Window when;
  double off_m = 0.0;
};

/// Faults that are not impairments of the network's packets.
struct Faults {
  std::vector<Window> outages = {};   ///< no datagram crosses the network in either direction
  std::vector<Window> restarts = {};  ///< the server is down; at the window's end it begins a new link session
  std::vector<Window> tracker_lost = {};
  std::vector<EncoderGlitch> glitches = {};
  std::vector<ClockStep> clock_steps = {};
};

/// Time that each stage takes in virtual time. The defaults are the medians that telepalp-bench pipeline measures.
struct StageTimes {
  Nanoseconds encode = std::chrono::milliseconds(5);  ///< from capture until the frame is offered to the link
  Nanoseconds decode = std::chrono::milliseconds(3);
  Nanoseconds build = std::chrono::milliseconds(5);
  Nanoseconds collision = std::chrono::milliseconds(1);  ///< of settings that need the collision detection
  Nanoseconds effects = std::chrono::milliseconds(12);   ///< for one local model of a slow effect
};

/// What a simulated person does at the device, round after round.
enum class HandScript : std::uint8_t {
  Examine,  ///< approaches, presses, holds, rubs to both sides, leaves
  Tap,      ///< taps the skin quickly at several places
  Search,   ///< stays in the skin and searches along it, shallow and deep
  Scene     ///< does what the scene's hand does: its trial
};

/// The network, the faults and the script of one run. Equal sources, scenes and scenarios give equal runs.
struct Scenario {
  impaired::Impairment down{};  ///< from the server to the station
  impaired::Impairment up{};
  Faults faults{};
  StageTimes stages{};
  Nanoseconds deadline = std::chrono::milliseconds(100);  ///< of a frame, from its capture
  HandScript hand = HandScript::Examine;                  ///< if no hand is recorded
  std::uint64_t seed = 1;                                 ///< of the network and the simulated tracker
};

/// `scenario`'s stages, deadline, hand and seed, with a network without delay, loss and faults.
[[nodiscard]] inline Scenario unimpaired(const Scenario& scenario) {
  return {.stages = scenario.stages, .deadline = scenario.deadline, .hand = scenario.hand, .seed = scenario.seed};
}

/// The session time at which each replay begins. Not 0, which messages use for "none yet".
inline constexpr SessionTime kBegin{std::chrono::seconds(10)};
inline constexpr Nanoseconds kTick{500'000};  ///< 2 kHz

}  // namespace telepalp::replay
