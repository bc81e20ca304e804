// Scenes with soft prisms: their fields, their objects in a picture, and what is refused.

#include <gtest/gtest.h>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/virtual_effects.h"
#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/scenes/scene_objects.h"
#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/trials/virtual_station.h"
#include "where.h"

namespace telepalp::scenes {
namespace {

Result<Scene> scene_with(const std::string& prism) {
  return parse_scene("haptic_from_camera { translation_m { y: 0.8 } }\neffects { fem_prism {\n" + prism + " } }",
                     TELEPALP_SOURCE_DIR "/haptic_station/scenes/prism.scene.textproto");
}

std::string said_about(const std::string& prism) {
  const Result<Scene> scene = scene_with(prism);
  return scene.ok() ? "accepted" : to_string(scene.error());
}

TEST(PrismScene, ItsFieldsAreReadIntoTheirSettings) {
  const Result<Scene> scene = scene_with(
      "name: \"soft\" foot_m { x: 0.1 y: -0.2 z: 0.03 } size_m { x: 0.03 y: 0.09 z: 0.02 } top_N_per_m: 900 poisson: "
      "0.3 "
      "coupling_N_per_m: 150 spread_m: 0.01 lets_go_N: 20 elements: ELEMENTS_LINEAR across: 1 along: 3");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  const auto& recipe = std::get<effects::FemPrismSettings>(scene->effects[0]);
  const tissue::PrismSettings& prism = recipe.model->settings;
  EXPECT_EQ(prism.name, "soft");
  EXPECT_EQ(prism.foot_m, Eigen::Vector3d(0.1, -0.2, 0.03));
  EXPECT_EQ(prism.grid.size_m, Eigen::Vector3d(0.03, 0.09, 0.02));
  EXPECT_EQ(prism.grid.order, tissue::ElementOrder::Linear);
  EXPECT_EQ(std::pair(prism.grid.across, prism.grid.along), std::pair(1, 3));
  EXPECT_EQ(
      std::vector<double>({prism.top_N_per_m, prism.poisson, prism.coupling_N_per_m, prism.spread_m, prism.lets_go_N}),
      std::vector<double>({900.0, 0.3, 150.0, 0.01, 20.0}));
}

TEST(PrismScene, NumbersOutOfRangeAreRefusedAtTheirPlace) {
  EXPECT_NE(said_about("poisson: 0.5").find("scene.textproto:3:"), std::string::npos);
  EXPECT_NE(said_about("poisson: 0.5").find("fem_prism.poisson is 0.5"), std::string::npos);
  EXPECT_NE(said_about("top_N_per_m: nan").find("fem_prism.top_N_per_m is nan"), std::string::npos);
  EXPECT_NE(said_about("size_m { x: 0.02 }").find("fem_prism.size_m.y is 0"), std::string::npos);
  EXPECT_NE(said_about("across: 9").find("fem_prism.across is 9"), std::string::npos);
  EXPECT_NE(said_about("coupling_N_per_m: 0").find("fem_prism.coupling_N_per_m is 0"), std::string::npos);
}

TEST(PrismScene, IsDrawnAsABox) {
  const auto file = find_scene("prisms_to_compare");
  ASSERT_TRUE(file.ok());
  const Result<Scene> scene = read_scene(*file);
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  const std::vector<SceneObject> objects = objects_of(*scene);
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "nominal");
  EXPECT_NEAR(objects[0].tree->box().high.y(), -0.01, 1e-9);
  EXPECT_NEAR(objects[1].tree->box().low.x(), 0.03, 1e-9);
}

/// The hand holds the end-effector by friction alone.
TEST(PrismScene, ItsHandPressesBothPrisms) {
  const auto file = find_scene("prisms_to_compare");
  ASSERT_TRUE(file.ok());
  const Result<Scene> scene = read_scene(*file);
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  core::BuiltEffects built = core::build_effects(scene->effects);
  core::VirtualEffects slow(std::move(built.stages));
  trials::VirtualStationSettings settings;
  settings.control = scene->control;
  settings.effects = built.bank;
  trials::VirtualStation station(settings);
  station.place({{0.0, 0.03, 0.0}}, {{0.0, 0.07, 0.0}});
  device::ScriptedIntention person(device::waypoints(scene->trial), {});
  const device::BreathingPlane skin{.amplitude_m = 0.0};
  double left_N = 0.0;
  double right_N = 0.0;
  while (station.time_s() < device::duration_s(scene->trial)) {
    slow.advance(SessionTime{from_seconds(station.time_s())}, {station.pair().device()}, std::chrono::milliseconds(12));
    const auto out = station.step(skin, [&](const device::TrialView& view) { return person.step(view, 0.0005); });
    left_N = std::max(left_N, out.force.N.x());
    right_N = std::max(right_N, -out.force.N.x());
  }
  EXPECT_GT(left_N, 1.0);
  EXPECT_GT(right_N, 1.0);
}

TEST(PrismScene, OnlyAPrismHasASlowStage) {
  EXPECT_EQ(core::build_effects(scene_with("")->effects).stages.size(), 1U);
  const auto file = find_scene("palpation");
  EXPECT_TRUE(core::build_effects(read_scene(*file)->effects).stages.empty());
}

}  // namespace
}  // namespace telepalp::scenes
