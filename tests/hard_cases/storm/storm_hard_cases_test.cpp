#include "tests/hard_cases/hard_case.h"
#include "tools/replay/storm/storm.h"

namespace telepalp::hard_cases {
namespace {

using namespace std::chrono_literals;
using replay::StormCase;

/// The arm presses from 3.2 s on, and leaves after 8 s.
StormCase over(Nanoseconds delay, double loss, replay::Faults faults) {
  StormCase storm{.motion = "irregular", .patient_seed = 1, .scene = "palpation", .scenario = {}, .seconds = 8.0};
  storm.scenario.down = storm.scenario.up = {.delay = delay, .loss = loss, .burst_packets = loss > 0.0 ? 12.0 : 1.0};
  storm.scenario.deadline = 100ms + delay;
  storm.scenario.faults = std::move(faults);
  return storm;
}

/// As a storm drew it.
StormCase drawn(const char* motion, const char* scene, double seconds, std::uint64_t seed, impaired::Impairment network,
                replay::Faults faults) {
  StormCase storm{.motion = motion, .patient_seed = 1, .scene = scene, .scenario = {}, .seconds = seconds};
  storm.scenario.seed = seed;
  storm.scenario.down = storm.scenario.up = network;
  storm.scenario.deadline = 100ms + network.delay;
  storm.scenario.faults = std::move(faults);
  return storm;
}

StormCase tapping(StormCase storm) {
  storm.scenario.hand = replay::HandScript::Tap;
  return storm;
}

::testing::AssertionResult invariants_hold(const StormCase& storm) {
  const auto outcome = replay::run_case(storm);
  if (!outcome) return ::testing::AssertionFailure() << to_string(outcome.error());
  if (outcome->violation)
    return ::testing::AssertionFailure() << replay::in_words(*outcome->violation) << ": telepalp-replay "
                                         << replay::command_line(storm);
  return ::testing::AssertionSuccess() << "every invariant at each tick of " << storm.seconds << " s";
}

const HardCase kRows[] = {
    {"the clock steps while nothing arrives", "the newest surface has two ages", "let go, and feel again",
     [] {
       return invariants_hold(over(60ms, 0.0, {.outages = {{3500ms, 1500ms}}, .clock_steps = {{{4s, 400ms}, -300ms}}}));
     }},
    {"the server restarts within an outage", "two ends begin a session apart", "feel again",
     [] {
       return invariants_hold(over(40ms, 0.0, {.outages = {{3s, 1s}}, .restarts = {{2500ms, 1s}}}));
     }},
    {"the server restarts, and the hand sinks to the cylinder", "nothing has been seen yet of the skin above it",
     "the cylinder is as deep below the displayed skin",
     [] {
       return invariants_hold(
           drawn("regular", "palpation", 4.0, 294, {.delay = 271ms, .loss = 0.19}, {.restarts = {{614ms, 2054ms}}}));
     }},
    {"the clock steps over a hand in sliding skin", "a share of the contact that grows over a deep hand",
     "the skin returns whole, from the hand",
     [] {
       return invariants_hold(
           drawn("regular", "skin_sliding", 5.0, 65, {}, {.clock_steps = {{{1858ms, 1297ms}, 65ms}}}));
     }},
    {"a tap throws the device 230 mm deep while nothing arrives", "no contact begins deeper than 90 mm",
     "lifted, then felt",
     [] {
       StormCase storm = tapping(drawn("cough", "palpation", 9.0, 376, {.delay = 180ms, .jitter = 40ms, .loss = 0.02},
                                       {.outages = {{1053ms, 1253ms}}}));
       storm.patient_seed = 836;
       storm.width_px = 640;
       return invariants_hold(storm);
     }},
    {"a tap drives the device into the rising cylinder", "skin and cylinder ask for 25 N; the device gives 10 N",
     "no energy where the push slips to the cylinder's side",
     [] {
       return invariants_hold(tapping(drawn("regular", "palpation", 11.0, 111, {}, {.restarts = {{5165ms, 1854ms}}})));
     }},
    {"a tap at a cylinder that rises after a cough", "skin and cylinder ask for more than the device gives",
     "no energy where the push slips to the cylinder's side",
     [] {
       StormCase storm = tapping(drawn("cough", "palpation", 8.0, 376, {}, {.outages = {{1053ms, 1253ms}}}));
       storm.patient_seed = 836;
       return invariants_hold(storm);
     }},
    {"sliding skin comes back into sight over a hand 140 mm deep",
     "its support grows while it is displayed at the hand", "no indentation that the hand did not make",
     [] {
       StormCase storm =
           tapping(drawn("shift", "skin_sliding", 4.0, 683,
                         {.delay = 232ms, .jitter = 45ms, .loss = 0.1, .burst_packets = 3.0, .rate_B_per_s = 8.875e6},
                         {.restarts = {{720ms, 1065ms}}, .glitches = {{{928ms, 4ms}, -0.053}}}));
       storm.patient_seed = 28;
       return invariants_hold(storm);
     }},
    {"a tap goes in through skin that fades with age, and images return",
     "a fifth of the skin, which grows to all of it", "the whole skin, from zero force on",
     [] {
       return invariants_hold(
           tapping(drawn("regular", "skin", 4.0, 996, {.delay = 91ms, .loss = 0.1}, {.outages = {{1090ms, 895ms}}})));
     }},
    {"a hand sinks 230 mm deep while the tracker is silent", "the contact went on below the depth at which one begins",
     "the station lifts the device first",
     [] {
       return invariants_hold(
           tapping(drawn("shift", "skin", 6.0, 852, {.delay = 171ms}, {.tracker_lost = {{1691ms, 2928ms}}})));
     }},
    {"an encoder glitch in deep contact", "the force of a jump is above the peak", "bounded force and slew",
     [] {
       return invariants_hold(over(20ms, 0.0, {.glitches = {{{4s, 4ms}, -0.06}, {{4100ms, 1ms}, 0.06}}}));
     }},
    {"the tracker is lost while surfaces age", "hand and surface are both predicted", "no energy from either",
     [] {
       return invariants_hold(over(300ms, 0.2, {.tracker_lost = {{3s, 2s}}}));
     }},
    {"bursts of twelve over 300 ms", "repairs arrive after the deadline", "felt on surfaces of any age",
     [] { return invariants_hold(over(300ms, 0.2, {})); }},
};

class StormHardCase : public HardCaseTable {};

TEST_P(StormHardCase, Holds) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, StormHardCase, ::testing::ValuesIn(kRows), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
