#include "haptic_station/surface/build/setting_choice.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/periods.h"

namespace telepalp::surface {
namespace {

bool feed(SettingChoice& choice, double cost_s, double seconds) {
  bool changed = false;
  for (double at_s = 0.0; at_s < seconds; at_s += kFrame_s) changed |= choice.add(cost_s, kFrame_s);
  return changed;
}

TEST(SettingChoice, AFastMachineKeepsTheScenesSetting) {
  SettingChoice choice{SurfaceSettings{}};
  EXPECT_FALSE(feed(choice, 0.008, 60.0));
  EXPECT_EQ(choice.now().name, SurfaceSettings{}.name);
}

TEST(SettingChoice, OneSlowSnapshotChangesNothing) {
  SettingChoice choice{SurfaceSettings{}};
  for (int second = 0; second < 60; ++second) {
    EXPECT_FALSE(choice.add(0.1, kFrame_s));
    EXPECT_FALSE(feed(choice, 0.003, 1.0));
  }
}

TEST(SettingChoice, ASlowMachineGetsACoarserLatticeOfTheSameMethod) {
  SettingChoice choice{SurfaceSettings{}};
  EXPECT_TRUE(feed(choice, 0.025, 1.0));
  EXPECT_GT(choice.now().node_step_px, SurfaceSettings{}.node_step_px);
  EXPECT_EQ(choice.now().method, SurfaceSettings{}.method);
  EXPECT_NE(choice.now().name, SurfaceSettings{}.name) << "the choice is published by name";
}

TEST(SettingChoice, TheBetterOneIsRetriedWithBackOff) {
  SettingChoice choice{SurfaceSettings{}};
  int tries = 0;
  for (double at_s = 0.0; at_s < 3600.0; at_s += kFrame_s) {
    const bool best = choice.now().node_step_px == SurfaceSettings{}.node_step_px;
    if (choice.add(best ? 0.025 : 0.004, kFrame_s) && best) ++tries;
  }
  EXPECT_GT(tries, 2);
  EXPECT_LT(tries, 15);
}

TEST(SettingChoice, TheFirstRetryComesAfterTenSecondsAndTheSecondAfterTwenty) {
  SettingChoice choice{SurfaceSettings{}};
  for (const double retry_after_s : {10.0, 20.0, 40.0}) {
    ASSERT_TRUE(feed(choice, 0.025, 0.5)) << "too slow: a cheaper setting";
    EXPECT_FALSE(feed(choice, 0.004, retry_after_s - 0.5));
    EXPECT_TRUE(feed(choice, 0.004, 1.0)) << "after " << retry_after_s << " s";
  }
}

TEST(SettingChoice, EveryCheaperSettingHasTheSameMethod) {
  for (const SurfaceSettings& asked : all_surface_settings())
    for (const SurfaceSettings& one : affordable_settings(asked)) {
      EXPECT_EQ(one.method, asked.method) << one.name;
      EXPECT_EQ(one.temporal, asked.temporal) << one.name;
    }
}

}  // namespace
}  // namespace telepalp::surface
