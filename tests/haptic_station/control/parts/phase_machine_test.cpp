#include "haptic_station/control/parts/phase_machine.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

std::optional<Event> after(PhaseMachine& machine, const Seen& seen, int ticks, FaultCause stands = FaultCause::None) {
  std::optional<Event> last;
  for (int tick = 0; tick < ticks; ++tick)
    if (const auto event = machine.step(seen, stands, kTick_s)) last = event;
  return last;
}

TEST(PhaseMachine, WaitsItsDwellBeforeItComesBack) {
  PhaseMachine machine(0.3);
  EXPECT_FALSE(after(machine, {}, 590));
  EXPECT_EQ(after(machine, {}, 20), Event::InputsBack);
  EXPECT_EQ(machine.phase(), Phase::BodyToPlane);
}

TEST(PhaseMachine, ReleasedLastsUntilTheInputsWereGoodForTheWholeDwell) {
  PhaseMachine machine(0.3);
  Seen stale;
  stale.inputs_stale = true;
  for (int round = 0; round < 10; ++round) {
    EXPECT_FALSE(after(machine, {}, 500));
    EXPECT_FALSE(after(machine, stale, 1));
  }
}

/// The hand outside the skin, and in it; good inputs.
Seen outside() {
  Seen seen;
  seen.outside = true;
  return seen;
}
Seen inside() {
  Seen seen;
  seen.in_body = true;
  return seen;
}
Seen stale(Seen seen) {
  seen.inputs_stale = true;
  return seen;
}

TEST(PhaseMachine, InReleasedAHandThatComesFromOutsideMeetsTheSkinAtOnce) {
  PhaseMachine machine(0.3);
  EXPECT_FALSE(after(machine, outside(), 1));
  EXPECT_EQ(after(machine, inside(), 1), Event::IntoBody);
  EXPECT_EQ(machine.phase(), Phase::InBody);
}

TEST(PhaseMachine, InReleasedAHandThatIsInTheBodyAlreadyWaitsForTheDwell) {
  PhaseMachine machine(0.3);
  EXPECT_FALSE(after(machine, inside(), 590));
  std::optional<Event> first;
  for (int tick = 0; tick < 20 && !first; ++tick) first = after(machine, inside(), 1);
  EXPECT_EQ(first, Event::InputsBack);
}

TEST(PhaseMachine, InReleasedAPlaceWithoutAKnownSurfaceIsNotOutside) {
  PhaseMachine machine(0.3);
  EXPECT_FALSE(after(machine, {}, 100));
  EXPECT_FALSE(after(machine, inside(), 400));
}

TEST(PhaseMachine, InReleasedAHandThatWasOutsideOnStaleInputsIsNotSeenOutside) {
  PhaseMachine machine(0.3);
  EXPECT_FALSE(after(machine, stale(outside()), 100));
  EXPECT_FALSE(after(machine, inside(), 400));
}

TEST(PhaseMachine, AHandThatWasOutsideAtTheReleaseMeetsTheSkinAsSoonAsTheInputsReturn) {
  PhaseMachine machine(0.3);
  ASSERT_EQ(after(machine, outside(), 610), Event::InputsBack);
  ASSERT_EQ(after(machine, stale(outside()), 1), Event::InputStale);
  EXPECT_FALSE(after(machine, stale(inside()), 1000));
  EXPECT_EQ(after(machine, inside(), 1), Event::IntoBody);
}

TEST(PhaseMachine, AHandThatWasInTheBodyAtTheReleaseWaitsForTheDwell) {
  PhaseMachine machine(0.3);
  ASSERT_FALSE(after(machine, outside(), 1));
  ASSERT_EQ(after(machine, inside(), 1), Event::IntoBody);
  ASSERT_EQ(after(machine, stale(inside()), 1), Event::InputStale);
  EXPECT_FALSE(after(machine, stale(outside()), 100));
  EXPECT_FALSE(after(machine, inside(), 590));
}

TEST(PhaseMachine, InputsThatComeAndGoNeverBeginAContactOnStaleOnesOrInsideTheBody) {
  PhaseMachine machine(0.3);
  ASSERT_FALSE(after(machine, outside(), 1));
  ASSERT_EQ(after(machine, inside(), 1), Event::IntoBody);
  for (int round = 0; round < 20; ++round) {  // 50 ms each
    after(machine, stale(inside()), 100);
    EXPECT_EQ(machine.phase(), Phase::Released);
    EXPECT_FALSE(after(machine, inside(), 100));
  }
}

TEST(PhaseMachine, KeepsTheCauseOfAFaultUntilItIsRearmed) {
  PhaseMachine machine(0.3);
  Seen seen;
  seen.fault_stands = true;
  EXPECT_EQ(after(machine, seen, 1, FaultCause::DeviceSilent), Event::Fault);
  EXPECT_EQ(machine.fault(), FaultCause::DeviceSilent);
  seen.fault_stands = false;
  EXPECT_FALSE(after(machine, seen, 1000));
  seen.rearm = true;
  EXPECT_EQ(after(machine, seen, 1), Event::Rearm);
  EXPECT_EQ(machine.fault(), FaultCause::None);
}

TEST(PhaseMachine, AForceThatIsNotFiniteIsTheFaultNotFinite) {
  PhaseMachine machine(0.3);
  Seen seen;
  seen.fault_latched = true;
  EXPECT_EQ(after(machine, seen, 1), Event::Fault);
  EXPECT_EQ(machine.fault(), FaultCause::NotFinite);
}

TEST(PhaseMachine, ChangesAtAnInnerObjectAreNoOuterChange) {
  PhaseMachine machine(0.3);
  Seen seen;
  (void)after(machine, seen, 700);  // Body to plane
  seen.in_body = true;
  (void)after(machine, seen, 700);
  ASSERT_EQ(machine.phase(), Phase::InBody);
  seen.touch = effects::ObjectTouch::Upper;
  ASSERT_EQ(after(machine, seen, 1), Event::TouchUpper);
  EXPECT_FALSE(machine.outer_change());
}

}  // namespace
}  // namespace telepalp::control
