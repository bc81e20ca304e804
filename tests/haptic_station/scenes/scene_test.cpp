#include "haptic_station/scenes/scene.h"
#include "haptic_station/core/built_effects.h"
#include "where.h"

#include <gtest/gtest.h>

namespace telepalp::scenes {
namespace {

constexpr const char* kLeastWithSkin = "haptic_from_camera { translation_m { y: 0.8 } } effects { skin {} }\n";

std::string complaint(const std::string& more) {
  const Result<Scene> scene = parse_scene(kLeastWithSkin + more, "bad.scene.textproto");
  return scene.ok() ? "" : to_string(scene.error());
}

TEST(Scene, EveryShippedSceneLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TELEPALP_SOURCE_DIR "/haptic_station/scenes")) {
    if (!entry.path().string().ends_with(".scene.textproto")) continue;
    const Result<Scene> scene = read_scene(entry.path());
    EXPECT_TRUE(scene.ok()) << to_string(scene.error());
    ++count;
  }
  EXPECT_GE(count, 2);
}

TEST(Scene, IsFoundByItsPathOrByTheNameOfOneThatShips) {
  const std::string folder = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";
  const Result<std::filesystem::path> shipped = find_scene("skin");
  ASSERT_TRUE(shipped.ok());
  EXPECT_EQ(shipped->filename(), "skin.scene.textproto");
  const Result<std::filesystem::path> given = find_scene(folder + "skin.scene.textproto");
  ASSERT_TRUE(given.ok());
  EXPECT_EQ(given->string(), folder + "skin.scene.textproto");
  for (const char* none : {"no_such_scene", "../scenes/skin", ""}) {
    const Result<std::filesystem::path> found = find_scene(none);
    ASSERT_FALSE(found.ok()) << none;
    EXPECT_EQ(found.error().where, none);
  }
}

TEST(Scene, ThePalpationSceneIsThePapers) {
  const Result<Scene> scene = read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/palpation.scene.textproto");
  ASSERT_TRUE(scene.ok());
  EXPECT_EQ(scene->effects.size(), 2U);
  const Point<HapticBase> skin = scene->haptic_from_camera * Point<DepthCamera>{{0.0, 0.0, 0.8}};
  EXPECT_LT(skin.m.norm(), 1e-9) << "0.8 m below the camera is H's origin";
  const Vector<HapticBase> up = scene->haptic_from_camera * Vector<DepthCamera>{{0.0, 0.0, -1.0}};
  EXPECT_LT((up.v - Eigen::Vector3d::UnitY()).norm(), 1e-9) << "towards the camera is up";
  EXPECT_DOUBLE_EQ(scene->control.transitions.dwell_s, 0.3);
}

TEST(Scene, ThePrintedPapersSceneHasItsPrintedLawAndItsCylinder) {
  const Result<Scene> scene = read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/paper_printed.scene.textproto");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  const effects::SkinSettings* skin = scene->skin();
  ASSERT_NE(skin, nullptr);
  const double stiffness_N_per_m =
      skin->law.constant_N_per_m + skin->law.slope_N_per_m2 * 0.06 + skin->law.curve_N_per_m3 * 0.06 * 0.06;
  EXPECT_NEAR(stiffness_N_per_m, 95.4, 0.01) << "S1 eq. (7) with alpha 1500 at 0.06 m";
  EXPECT_TRUE(skin->law.by_axis);
  EXPECT_EQ(skin->anchor, effects::SkinAnchor::Fixed);
  const effects::EffectBank bank = core::bank_of(scene->effects);
  ASSERT_EQ(bank.bill().size(), 2U);
  EXPECT_STREQ(bank.bill()[1].name, "cylinder");
}

TEST(Scene, AnUnknownFieldIsAnErrorWithLineAndColumn) {
  EXPECT_NE(complaint("plane { hight_m: 0.02 }").find("bad.scene.textproto:2:16"), std::string::npos)
      << complaint("plane { hight_m: 0.02 }");
}

TEST(Scene, AValueInAWrongUnitIsNamedWithItsUnitAndRange) {
  const std::string text = complaint("plane { height_m: 30 }");  // millimetres
  EXPECT_NE(text.find("plane.height_m is 30 m, outside -0.5 to 0.5 m"), std::string::npos) << text;
}

TEST(Scene, APeakAboveTheDevicesIsRefused) {
  EXPECT_NE(complaint("limits { peak_N: 30 }").find("10 N"), std::string::npos);
}

TEST(Scene, NotANumberIsRefused) { EXPECT_NE(complaint("plane { height_m: nan }"), ""); }

TEST(Scene, AWorkspaceIsIndexedOnlyIfTheSceneNamesIt) {
  const Result<Scene> plain = parse_scene(kLeastWithSkin, "plain.scene.textproto");
  ASSERT_TRUE(plain.ok());
  EXPECT_FALSE(plain->control.indexing.on);
  const Result<Scene> indexed =
      parse_scene(std::string(kLeastWithSkin) + "workspace { touch_radius_m: 0.08 }", "indexed");
  ASSERT_TRUE(indexed.ok()) << to_string(indexed.error());
  EXPECT_TRUE(indexed->control.indexing.on);
  EXPECT_EQ(indexed->control.indexing.touch_radius_m, 0.08);
  EXPECT_EQ(indexed->control.indexing.most_shift_z_m, 0.9) << "the default";
  EXPECT_NE(complaint("workspace { touch_radius_m: 80 }").find("workspace.touch_radius_m is 80 m"), std::string::npos);
  EXPECT_NE(complaint("workspace { most_shift_z_m: nan }"), "");
}

TEST(Scene, ASceneWithoutAnEffectIsRefused) {
  EXPECT_FALSE(parse_scene("haptic_from_camera {}", "empty.scene.textproto").ok());
}

TEST(Scene, EachEffectHasASceneThatNamesItAfterTheSkinAndNoOther) {
  const std::string folder = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";
  for (const std::string name : {"sphere", "friction", "regions", "organ"}) {
    const Result<Scene> scene = read_scene(folder + name + ".scene.textproto");
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    const effects::EffectBank bank = core::bank_of(scene->effects);
    ASSERT_EQ(bank.bill().size(), 2U);
    EXPECT_STREQ(bank.bill()[0].name, "skin");
    EXPECT_EQ(bank.bill()[1].name, name);
  }
}

TEST(Scene, AnOrgansFileIsNamedWhereItCannotBeUsed) {
  EXPECT_NE(complaint("effects { organ {} }").find("organ.file is empty"), std::string::npos);
  EXPECT_NE(complaint("effects { organ { file: \"none.ply\" } }").find("none.ply"), std::string::npos);
  const std::string open = TELEPALP_SOURCE_DIR "/deploy/demo_data/torso/visible_human_torso.ply";
  const std::string text = complaint("effects { organ { file: \"" + open + "\" } }");
  EXPECT_NE(text.find("visible_human_torso.ply: is not closed"), std::string::npos) << text;
}

TEST(Scene, FrictionWithoutASkinIsRefused) {
  const auto scene = parse_scene("haptic_from_camera {} effects { friction {} }", "dry.scene.textproto");
  ASSERT_FALSE(scene.ok());
  EXPECT_NE(to_string(scene.error()).find("friction needs a skin effect"), std::string::npos);
}

TEST(Scene, ASkinTakesACurveThatWasMeasured) {
  const auto scene = parse_scene(
      "haptic_from_camera {} effects { skin { measured { constant_N_per_m: 100 slope_N_per_m2: 2000 "
      "curve_N_per_m3: 5e4 } } }",
      "measured.scene.textproto");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  effects::EffectInput in;
  in.contact.normal = {Eigen::Vector3d::UnitY()};
  effects::EffectBank bank = core::bank_of(scene->effects);
  bank.begin(in);
  in.device.m = {0.0, -0.01, 0.0};
  in.contact.distance_m = -0.01;
  EXPECT_NEAR(bank.step(in, 0.0005).force.N.y(), 0.01 * (100.0 + 20.0 + 5.0), 1e-9);
  EXPECT_NE(complaint("effects { skin { tissue: \"muscle\" measured {} } }").find("more than one"), std::string::npos);
}

TEST(Scene, TwoWaysToGiveTheStiffnessAreOneTooMany) {
  EXPECT_NE(complaint("effects { skin { alpha_N_per_m2: 1500 stiffness_N_per_m: 160 } }").find("or the other two"),
            std::string::npos);
}

}  // namespace
}  // namespace telepalp::scenes
