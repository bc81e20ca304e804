#include "haptic_station/scenes/solid_text.h"

#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "tests/haptic_station/solids/random_solid.h"
#include "where.h"

namespace telepalp::scenes {
namespace {

std::string complaint_about_layer(const std::string& layer) {
  const Result<Scene> scene = parse_scene(
      "haptic_from_camera { translation_m { y: 0.8 } } effects { skin {} }\neffects { solid { " + layer + " } }",
      "bad.scene.textproto");
  return scene.ok() ? "" : to_string(scene.error());
}

TEST(SolidText, BothNotationsSayTheSame) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    solids::RandomSolid random(seed);
    const auto solid = solids::parse_polish(random.tree(static_cast<int>(seed % 6)), "random");
    ASSERT_TRUE(solid.ok());
    std::string text;
    ASSERT_TRUE(google::protobuf::TextFormat::PrintToString(message_of(*solid), &text));
    msg::Solid message;
    ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message));
    const auto again = solid_of(message, "test", solids::no_meshes);
    ASSERT_TRUE(again.ok()) << to_string(again.error()) << text;
    ASSERT_EQ(solids::to_polish(*again), solids::to_polish(*solid)) << "seed " << seed;
  }
}

TEST(SolidText, AUnionOfSeveralIsAChain) {
  msg::Solid message;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(
      "union { of { sphere { radius_m: 1 } } of { sphere { radius_m: 2 } } of { sphere { radius_m: 3 } } }", &message));
  const auto solid = solid_of(message, "test", solids::no_meshes);
  ASSERT_TRUE(solid.ok());
  EXPECT_EQ(solids::to_polish(*solid), "+ sphere 1 + sphere 2 sphere 3");
  EXPECT_EQ(message_of(*solid).union_().of_size(), 3);
}

TEST(SolidText, ALayersErrorNamesFileLayerAndPlace) {
  const std::pair<const char*, const char*> kBad[] = {
      {"polish: \"sphere 0.1\"", "the layer has no name"},
      {"name: \"x\"", "bad.scene.textproto:2:11: layer x: the layer has no solid"},
      {"name: \"x\" polish: \"sphere -1\"", "bad.scene.textproto:2:45: layer x: radius_m of sphere is -1"},
      {"name: \"x\" polish:\n\"+ sphere 1 \"  # first\n  \"sphere -2\"", "bad.scene.textproto:4:11: layer x: radius_m"},
      {R"(name: "x" polish: "sphere\t\n-3")", "bad.scene.textproto:2:48: layer x: radius_m of sphere is -3"},
      {"name: \"x\" polish: \"+ sphere 1\"", "bad.scene.textproto:2:48: layer x: expected the solid that is operand 2"},
      {"name: \"x\" stiffness_N_per_m: 0,5 polish: \"sphere 1\"", "write a decimal point"},
      {"name: \"x\" polish_file: \"none.solid\"", "bad.scene.textproto:2:43 names this file"},
      {"name: \"x\" polish: \"mesh none.ply 1 0.004\"", "bad.scene.textproto:2:38: layer x: none.ply: cannot be read"},
      {"name: \"x\"\nsolid { sphere {} }", "bad.scene.textproto:3:9: layer x: sphere: radius_m is missing"},
      {"name: \"x\"\nsolid { union { of { sphere { radius_m: 1 } } } }",
       "bad.scene.textproto:3:9: layer x: union: has 1 operand instead of 2 or more"},
      {"name: \"x\" solid { translate { x_m: 1 y_m: 0 z_m: nan of { sphere { radius_m: 1 } } } }",
       "bad.scene.textproto:2:63: layer x: translate: z_m of tr is nan"},
      {"name: \"x\" solid { difference { of { sphere { radius_m: 1 } } of {} } }",
       "bad.scene.textproto:2:80: layer x: difference.of[1]: the solid has no kind"},
      {"name: \"x\" polish: \"sphere 1\" stiffness_N_per_m: 90000", "solid.stiffness_N_per_m is 90000 N/m"},
  };
  for (const auto& [layer, wanted] : kBad)
    EXPECT_NE(complaint_about_layer(layer).find(wanted), std::string::npos)
        << layer << ": " << complaint_about_layer(layer);
}

TEST(SolidText, BracesNestedWithoutEndAreRefused) {
  std::string text = "name: \"x\" solid { ";
  for (int i = 0; i < 100'000; ++i) text += "scale{of{";
  EXPECT_NE(complaint_about_layer(text), "");
}

TEST(SolidText, EachLayerIsOnTheBillUnderItsName) {
  const auto scene = read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/liver-enlarged.scene.textproto");
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  std::string names;
  const effects::EffectBank bank = core::bank_of(scene->effects);
  for (const effects::EffectBill& line : bank.bill()) names += std::string(line.name) + " ";
  EXPECT_EQ(names, "skin liver spleen aorta ");
}

}  // namespace
}  // namespace telepalp::scenes
