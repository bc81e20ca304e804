#include "haptic_station/control/parts/phase_machine.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

constexpr double kTick_s = 0.0005;

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
