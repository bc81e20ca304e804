#include "haptic_station/control/parts/displayed_hand.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

struct Scene {
  ControlInput in;
  ports::SurfaceContact contact;
  DisplayedHand displayed{0.15};
  Scene() {
    in.hand_valid = true;
    in.hand.m = {0.0, -0.02, 0.0};
    contact.valid = true;
    contact.proxy.m = {0.0, 0.0, 0.0};
  }
  Point<HapticBase> at(bool inside, int ticks) {
    Point<HapticBase> shown;
    for (int tick = 0; tick < ticks; ++tick) shown = displayed.step(in, contact, inside, kTick_s);
    return shown;
  }
};

TEST(DisplayedHand, IsTheTrackedHandOutsideAndTheProxyInTheBody) {
  Scene scene;
  EXPECT_EQ(scene.at(false, 1).m, scene.in.hand.m);
  EXPECT_NEAR((scene.at(true, 6000).m - scene.contact.proxy.m).norm(), 0.0, 1e-8);
}

TEST(DisplayedHand, DoesNotJumpBetweenTheTwo) {
  Scene scene;
  const Point<HapticBase> outside = scene.at(false, 1);
  EXPECT_LT((scene.at(true, 1).m - outside.m).norm(), 1e-4);
}

TEST(DisplayedHand, StaysOnTheLastProxyWhenTheSurfaceIsLost) {
  Scene scene;
  const Point<HapticBase> before = scene.at(true, 6000);
  scene.contact = {};
  EXPECT_LT((scene.at(true, 1).m - before.m).norm(), 1e-8);
}

}  // namespace
}  // namespace telepalp::control
