#include "haptic_station/control/parts/input_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace telepalp::control {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

ControlInput good() {
  ControlInput in;
  in.hand_valid = true;
  in.contact.valid = true;
  return in;
}

TEST(InputCheck, UnusedNumbersAreNotChecked) {
  ControlInput in = good();
  EXPECT_TRUE(is_finite(in));
  in.hand.m.x() = in.contact.proxy.m.x() = kNaN;
  EXPECT_FALSE(is_finite(in));
  in.hand_valid = in.contact.valid = false;
  EXPECT_TRUE(is_finite(in));
}

TEST(InputCheck, EveryNumberOfAContactAndOfTheObjectsInTheBodyIsChecked) {
  const std::function<void(ControlInput&)> spoilers[] = {
      [](ControlInput& in) { in.contact.normal.v.z() = kNaN; },
      [](ControlInput& in) { in.contact.distance_m = kNaN; },
      [](ControlInput& in) { in.contact.coverage = kNaN; },
      [](ControlInput& in) { in.contact.surface_speed_m_per_s = kNaN; },
      [](ControlInput& in) { in.contact.measured_above_m = kNaN; },
      [](ControlInput& in) { in.contact.measured_speed_m_per_s = kNaN; },
      [](ControlInput& in) { in.contact.anchor_velocity.v.x() = kNaN; },
      [](ControlInput& in) { in.placements.back().moved.v.y() = kNaN; },
      [](ControlInput& in) { in.placements.front().velocity.v.z() = kNaN; },
  };
  int number = 0;
  for (const auto& spoil : spoilers) {
    ControlInput in = good();
    in.contact.anchor_seen = true;
    ASSERT_TRUE(is_finite(in));
    spoil(in);
    EXPECT_FALSE(is_finite(in)) << "number " << number++;
  }
}

TEST(InputCheck, AnAnchorThatIsNotSeenHasNoVelocityToCheck) {
  ControlInput in = good();
  in.contact.anchor_velocity.v.x() = kNaN;
  EXPECT_TRUE(is_finite(in));
}

TEST(InputCheck, ABlankInputIsFiniteStaleAndKeepsTheOperatorsRequest) {
  ControlInput in = good();
  in.device.m.x() = kNaN;
  in.rearm = true;
  const ControlInput blank = blank_input(in, {{0.0, 0.1, 0.0}});
  EXPECT_TRUE(is_finite(blank));
  EXPECT_TRUE(surface_is_stale(blank, {}));
  EXPECT_TRUE(hand_is_lost(blank, 3.0));
  EXPECT_TRUE(blank.rearm);
  EXPECT_EQ(blank.device.m.y(), 0.1);
}

TEST(InputCheck, NamesTheCauseOfAFault) {
  ControlInput in = good();
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::None);
  in.device_age_s = 0.11;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::DeviceSilent);
  in.device_age_s = kNaN;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::NotFinite);
  in.device_age_s = 0.0;
  in.device_implausible_s = 0.004;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::None) << "a glitch is bridged";
  in.device_implausible_s = 0.009;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::DeviceImplausible);
  in.device_implausible_s = 0.0;
  in.hand_implausible_s = 0.07;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::None) << "a tracker's glitch is held";
  in.hand_implausible_s = 0.09;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::HandImplausible);
  EXPECT_EQ(standing_fault(in, true, {}), FaultCause::None) << "the skin's force needs the device alone";
  in.hand_valid = false;
  EXPECT_EQ(standing_fault(in, false, {}), FaultCause::None) << "no hand has been seen";
}

TEST(InputCheck, AnAgeThatIsNaNOrFarInTheFutureIsStale) {
  for (const double age_s : {0.2, -0.2, kNaN}) {
    ControlInput in = good();
    in.hand_age_s = age_s;
    EXPECT_TRUE(hand_is_lost(in, 0.1)) << age_s;
  }
  ControlInput in = good();
  EXPECT_FALSE(hand_is_lost(in, 0.1));
  EXPECT_FALSE(surface_is_stale(in, {}));
  in.contact.age_s = kNaN;
  EXPECT_TRUE(surface_is_stale(in, {}));
}

}  // namespace
}  // namespace telepalp::control
