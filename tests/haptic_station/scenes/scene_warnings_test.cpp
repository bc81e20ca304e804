#include "haptic_station/scenes/scene_warnings.h"

#include <gtest/gtest.h>

#include "haptic_station/scenes/inside_search.h"
#include "haptic_station/solids/polish.h"
#include "where.h"

namespace telepalp::scenes {
namespace {

const std::string kCamera =
    "haptic_from_camera { translation_m { y: 0.8 } rotation_vector_rad { x: 1.5708 } }\n"  // line 1
    "center_on_surface: true\n"
    "effects { skin {} }\n";  // line 3

/// A layer whose Polish text begins at column 38 of line 4.
std::string layer(const std::string& polish) {
  return kCamera + "effects { solid { name: \"m\" polish: \"" + polish + "\" } }";
}

std::string warnings_of(const std::string& text) {
  const Result<Scene> scene = parse_scene(text, "s.textproto");
  if (!scene) return "error: " + to_string(scene.error());
  std::string all;
  for (const Error& warning : scene->warnings) all += to_string(warning) + "\n";
  return all;
}

struct Mistake {
  const char* name;
  std::string scene;
  const char* place;
  const char* what;
  const char* fix;
};

const Mistake kMistakes[] = {
    {"millimetres", layer("tr 0 -30 0 sphere 10"), "4:11", "20 m long", "in metres"},
    {"millimetres, a small ball", layer("tr 30 -30 -20 sphere 0.01"), "4:11", "46.9 m from the origin", "within 1 m"},
    {"an empty intersection", layer("* tr 0 -0.05 0 sphere 0.01 tr 0.05 -0.05 0 sphere 0.01"), "4:11", "is empty",
     "may not meet"},
    {"a clip that leaves nothing", layer("clip 0 1 0 -0.2 tr 0 -0.05 0 sphere 0.01"), "4:11", "is empty", "clips"},
    {"a ball 5 m away", layer("tr 5 -0.05 0 sphere 0.02"), "4:11", "5 m from the origin", "within 1 m"},
    {"a sign forgotten", layer("tr 0 0.03 0 sphere 0.01"), "4:11", "above the skin", "negative y"},
    {"a ball that sticks out", layer("tr 0.1 -0.01 0 sphere 0.02"), "4:11", "rises more than 2 mm above the skin",
     "y = 0"},
    {"too deep", layer("tr 0 -0.4 0 sphere 0.02"), "4:11", "380 mm below the skin", "between -0.2 and 0"},
    {"a plane the wrong way round", layer("plane 0 -1 0 0.05"), "4:11", "contains the origin", "normal"},
    {"ring and tube swapped", layer("tr 0 -0.1 0 torusx 0.009 0.082"), "4:50", "above the ring's",
     "ring's radius first"},
    {"radians", layer("tr 0 -0.15 0 # arcz 0\\n arcz 0.1 0.008 0 3.14159"), "4:62", "to 3.14159 degrees",
     "not radians"},
    {"nothing taken away", layer("- tr 0 -0.05 0 sphere 0.01 tr 0 -0.1 0 sphere 0.01"), "4:38", "nothing is taken away",
     "move"},
    {"nothing cut off", layer("tr 0 -0.05 0 clip 0 1 0 0.03 sphere 0.01"), "4:51", "nothing is cut off", "own frame"},
    {"newtons per millimetre", kCamera + "effects { sphere { center_m { y: -0.05 } stiffness_N_per_m: 0.8 } }", "4:42",
     "0.8 N/m", "1000 N/m"},
    {"a copy",
     layer("tr 0 -0.05 0 sphere 0.01") + "\neffects { solid { name: \"n\" polish: \"tr 0 -0.05 0 sphere 0.01\" } }",
     "5:11", "layer n has the shape and place of layer m", "remove"},
    {"a camera that looks along the body", "haptic_from_camera { translation_m { y: 0.8 } }\neffects { skin {} }",
     "1:1", "does not look down", "x: 1.5708"},
    {"friction that never acts", kCamera + "effects { friction {} }", "4:11", "hand that slides", "ANCHOR_SLIDING"},
};

TEST(SceneWarnings, EachMistakeIsToldOnceWithItsPlaceAndRemedy) {
  for (const Mistake& mistake : kMistakes) {
    const std::string all = warnings_of(mistake.scene);
    EXPECT_EQ(std::ranges::count(all, '\n'), 1) << mistake.name << ":\n" << all;
    EXPECT_TRUE(all.starts_with("s.textproto:" + std::string(mistake.place) + ": ")) << mistake.name << ": " << all;
    EXPECT_NE(all.find(mistake.what), std::string::npos) << mistake.name << ": " << all;
    const std::size_t fix = all.find("fix: ");
    ASSERT_NE(fix, std::string::npos) << mistake.name << ": " << all;
    EXPECT_NE(all.find(mistake.fix, fix), std::string::npos) << mistake.name << ": " << all;
  }
}

TEST(SceneWarnings, ScenesThatShipGiveNone) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TELEPALP_SOURCE_DIR "/haptic_station/scenes")) {
    if (!entry.path().string().ends_with(".scene.textproto")) continue;
    const Result<Scene> scene = read_scene(entry.path());
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    for (const Error& warning : scene->warnings) ADD_FAILURE() << to_string(warning);
    ++read;
  }
  EXPECT_GE(read, 15);
}

TEST(SceneWarnings, WhatIsMeantGivesNone) {
  for (const char* polish :
       {"tr 0 -0.05 0 box 0.03 0.0004 0.03", "tr 0 -0.05 0 - sphere 0.02 sphere 0.0199", "plane 0 1 0 -0.05",
        "sc 0.001 tr 0 -50 0 sphere 20", "tr 0 -0.05 0 * tr 0.0195 0 0 sphere 0.02 tr -0.0195 0 0 sphere 0.02"})
    EXPECT_EQ(warnings_of(layer(polish)), "") << polish;
}

TEST(InsideSearch, FindsThinWallsAndProvesThatThereIsNothing) {
  const auto search = [](const std::string& text) {
    const auto tree = *solids::build_tree(*solids::parse_polish(text, "test"));
    return find_inside(*tree, tree->box());
  };
  EXPECT_EQ(search("ro 30 1 2 3 box 0.1 0.00001 0.1"), Search::Inside);
  EXPECT_EQ(search("- sphere 0.1 sphere 0.09999"), Search::Inside);
  EXPECT_EQ(search("- sphere 0.1 sphere 0.11"), Search::NothingInside);
  EXPECT_EQ(search("* sphere 0.1 tr 0.19 0.08 0 sphere 0.1"), Search::NothingInside);
}

}  // namespace
}  // namespace telepalp::scenes
