#include "haptic_station/control/safety/hand_ledger.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

using Eigen::Vector3d;

const Vector3d kUp_m(0.0, 0.001, 0.0);

TEST(HandLedger, IsZeroWhereTheDeviceDoesWhatTheReferenceDoes) {
  HandLedger ledger;
  ledger.book({}, Vector3d(0.0, 2.0, 0.0), Vector3d::Zero());
  ledger.book({.skin = Vector3d(0.0, 2.0, 0.0)}, Vector3d(0.0, 2.0, 0.0), kUp_m);
  EXPECT_DOUBLE_EQ(ledger.excess_J(), 0.0);
}

TEST(HandLedger, ShowsWhatAForceThatShouldBeGoneGivesTheHand) {
  HandLedger ledger;
  ledger.book({.skin = Vector3d(0.0, 2.0, 0.0)}, Vector3d::Zero(), kUp_m);
  EXPECT_DOUBLE_EQ(ledger.excess_J(), 0.002);
}

TEST(HandLedger, BooksFadesWithTheSkinAndTheDriveSeparately) {
  HandLedger ledger;
  ledger.book({.fade = Vector3d(0.0, 1.0, 0.0), .drive = Vector3d(0.0, 3.0, 0.0)}, Vector3d::Zero(), kUp_m);
  EXPECT_DOUBLE_EQ(ledger.excess_J(), 0.001);
  EXPECT_DOUBLE_EQ(ledger.fades_J(), 0.001);
  EXPECT_DOUBLE_EQ(ledger.drive_J(), 0.003);
}

TEST(HandLedger, TheReferencesWorkIsExactForASpring) {
  HandLedger ledger;
  const auto spring_N = [](double depth_m) { return Vector3d(0.0, 500.0 * depth_m, 0.0); };
  for (int tick = 0; tick < 20; ++tick)
    ledger.book({.skin = Vector3d::Zero()}, spring_N(0.02 - 0.001 * (tick + 1)), tick == 0 ? Vector3d::Zero() : kUp_m);
  EXPECT_NEAR(ledger.excess_J(), -0.5 * 500.0 * 0.019 * 0.019, 1e-12) << "from 19 mm to the skin";
}

}  // namespace
}  // namespace telepalp::control
