#include "haptic_station/effects/skin.h"

#include <gtest/gtest.h>

#include "haptic_station/effects/effect_bank.h"
#include "tests/haptic_station/effects/level_skin.h"

namespace telepalp::effects {
namespace {

TEST(SkinLaw, TheDefaultFollowsTheStatedStiffness) {
  const SkinLaw law;
  EXPECT_NEAR(law.stiffness_N_per_m(0.06), 160.0, 1e-9);
  EXPECT_NEAR(law.slope_N_per_m2, 2516.0, 1.0);
  EXPECT_NEAR(skin_force_N(law, {0.0, -0.06, 0.0}).norm(), 9.6, 1e-9);  // the text rounds it to 9.5 N
}

TEST(SkinLaw, ThePrintedAlphaGivesThePrintedEquation) {
  const SkinLaw law = paper_law(1500.0);
  EXPECT_NEAR(law.stiffness_N_per_m(0.06), 95.4, 1e-9);
  EXPECT_NEAR(skin_force_N(law, {0.0, -0.06, 0.0}).y(), 5.724, 1e-9);
}

TEST(SkinLaw, ByAxisANegativeComponentPushesBackToo) {
  const SkinLaw law{.by_axis = true};
  const Eigen::Vector3d force_N = skin_force_N(law, {0.02, -0.03, -0.01});
  EXPECT_LT(force_N.x(), 0.0);
  EXPECT_GT(force_N.y(), 0.0);
  EXPECT_GT(force_N.z(), 0.0);
  EXPECT_NEAR(force_N.y(), law.stiffness_N_per_m(0.03) * 0.03, 1e-12);
}

TEST(SkinLaw, ForceIsTheGradientOfTheStoredEnergy) {
  for (const bool by_axis : {false, true}) {
    const SkinLaw law{.by_axis = by_axis};
    const Eigen::Vector3d d{0.012, -0.034, 0.007};
    for (int i = 0; i < 3; ++i) {
      constexpr double kStep_m = 1e-6;
      const Eigen::Vector3d step = Eigen::Vector3d::Unit(i) * kStep_m;
      const double slope = (skin_energy_J(law, d + step) - skin_energy_J(law, d - step)) / (2.0 * kStep_m);
      EXPECT_NEAR(skin_force_N(law, d)[i], -slope, 1e-6);
    }
  }
}

TEST(Skin, FollowsEquations6To8WithinHalfAPercentOverSixtyMillimetres) {
  for (const SkinAnchor anchor : {SkinAnchor::FollowsSurface, SkinAnchor::Fixed}) {
    Skin skin({.law = {}, .anchor = anchor});
    skin.begin(over_level_skin({0.01, -1e-6, 0.02}));
    for (double depth_m = 0.001; depth_m <= 0.06; depth_m += 0.001) {
      const Eigen::Vector3d device{0.01 + 0.3 * depth_m, -depth_m, 0.02 - 0.2 * depth_m};
      const Eigen::Vector3d d = device - Eigen::Vector3d{0.01, 0.0, 0.02};
      const double k = (160.0 / 0.0636) * (d.squaredNorm() + d.norm());  // eq. (7), isotropic
      const Eigen::Vector3d expected_N = -k * d;                         // eq. (6) and (8)
      const Eigen::Vector3d given_N = skin.step(over_level_skin(device), 0.0005).N;
      ASSERT_LE((given_N - expected_N).norm(), 0.005 * expected_N.norm()) << depth_m;
    }
  }
}

TEST(Skin, AnchoredItBreathesWithThePatientAndFixedItDoesNot) {
  EffectInput in = over_level_skin({0.0, -0.02, 0.0});
  Skin follows({.law = {}, .anchor = SkinAnchor::FollowsSurface});
  Skin fixed({.law = {}, .anchor = SkinAnchor::Fixed});
  follows.begin(over_level_skin({0.0, 0.0, 0.0}));
  fixed.begin(over_level_skin({0.0, 0.0, 0.0}));
  const double before_N = follows.step(in, 0.0005).N.y();
  const double fixed_before_N = fixed.step(in, 0.0005).N.y();
  in.contact.surface_speed_m_per_s = 0.01;  // breathes in by 5 mm in half a second
  double after_N = 0.0;
  for (int tick = 0; tick < 1000; ++tick) {
    in.contact.proxy.m.y() += 0.01 * 0.0005;
    after_N = follows.step(in, 0.0005).N.y();
  }
  EXPECT_GT(after_N, 1.2 * before_N);
  EXPECT_DOUBLE_EQ(fixed.step(in, 0.0005).N.y(), fixed_before_N);
}

TEST(Skin, AProxyThatSlidesDownTheBodysCurvatureDoesNotMoveTheAnchor) {
  EffectInput in = over_level_skin({0.0, -0.03, 0.0});
  Skin skin;
  skin.begin(over_level_skin({0.0, 0.0, 0.0}));
  const double before_N = skin.step(in, 0.0005).N.y();
  in.contact.proxy.m = {0.02, -0.002, 0.0};  // another part of the skin is now the nearest; the patient lies still
  EXPECT_DOUBLE_EQ(skin.step(in, 0.0005).N.y(), before_N);
}

TEST(Skin, NeverPullsTheHandIntoTheBody) {
  Skin skin;
  skin.begin(over_level_skin({0.0, -0.001, 0.0}));
  EXPECT_LE(std::abs(skin.step(over_level_skin({0.0, 0.03, 0.0}), 0.0005).N.y()), 0.0);
}

TEST(Skin, SlidingItPushesAlongTheNormalAlone) {
  Skin skin({.law = {}, .anchor = SkinAnchor::Sliding});
  skin.begin(over_level_skin({0.0, -0.001, 0.0}));
  const Eigen::Vector3d force_N = skin.step(over_level_skin({0.03, -0.02, -0.01}), 0.0005).N;
  EXPECT_EQ(force_N.x(), 0.0);
  EXPECT_EQ(force_N.z(), 0.0);
  EXPECT_NEAR(force_N.y(), SkinLaw{}.stiffness_N_per_m(0.02) * 0.02, 1e-12);
}

TEST(EffectBank, StepsAndBillsOnlyWhatTheSceneNames) {
  EffectBank bank;
  ASSERT_TRUE(bank.add(Skin{}));
  bank.begin(over_level_skin({0.0, -0.001, 0.0}));
  for (int i = 0; i < 10; ++i) (void)bank.step(over_level_skin({0.0, -0.05, 0.0}), 0.0005);
  ASSERT_EQ(bank.bill().size(), 1U);
  EXPECT_STREQ(bank.bill()[0].name, "skin");
  EXPECT_EQ(bank.bill()[0].steps, 10U);
}

TEST(EffectBank, SaysWhenItIsFull) {
  EffectBank bank;
  for (std::size_t i = 0; i < EffectBank::kMostEffects; ++i) EXPECT_TRUE(bank.add(Skin{}));
  EXPECT_FALSE(bank.add(Skin{}));
}

}  // namespace
}  // namespace telepalp::effects
