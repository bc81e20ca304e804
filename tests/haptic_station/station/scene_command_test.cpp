#include "haptic_station/station/commands/scene_command.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "haptic_station/scenes/scene_objects.h"
#include "support/images/image_file.h"
#include "support/images/lettering.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::station {
namespace {

const std::string kScenes = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";
const std::string kCamera = "haptic_from_camera { translation_m { y: 0.8 } rotation_vector_rad { x: 1.5708 } } ";
const std::string kMass = kScenes + "mass-search.scene.textproto";

struct Outcome {
  int code;
  std::string out;
  std::string err;
};
Outcome run(std::vector<std::string> words) {
  std::vector<const char*> argv{"scene"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = scene_command(static_cast<int>(argv.size()), argv.data());
  std::fflush(stdout);
  return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

std::string written(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file.string();
}

class SceneCommand : public ::testing::Test {
 protected:
  [[nodiscard]] std::string file(const char* name) const { return (folder_.path() / name).string(); }
  support::TemporaryFolder folder_;
};

TEST_F(SceneCommand, CheckNamesTheEffects) {
  const Outcome done = run({"check", kMass});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.out, "mass-search: the scene is valid; search for a hidden mass by palpation; effects: skin, mass\n");
}

TEST_F(SceneCommand, BillPricesTheEffectsThatTheSceneNames) {
  const Outcome done = run({"bill", kMass, "--seconds", "3"});
  EXPECT_EQ(done.code, 0) << done.err;
  for (const char* line : {"control loop, a tick ", "surface, an image ", "\nskin ", "\nmass ", "\nall of these "})
    EXPECT_NE(done.out.find(line), std::string::npos) << line << " in\n" << done.out;
  EXPECT_EQ(done.out.find("liver"), std::string::npos) << "an effect that the scene does not name is not priced";
}

TEST_F(SceneCommand, ShowAndImageWritePicturesThatAreNotEmpty) {
  for (const char* task : {"show", "image"}) {
    const Outcome done = run({task, kMass, "--out", file("picture.png")});
    ASSERT_EQ(done.code, 0) << done.err;
    const auto image = images::read_color_image(file("picture.png"));
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    EXPECT_GE(image->width, 256);
    EXPECT_NE(std::ranges::min(image->rgb), std::ranges::max(image->rgb)) << task;
  }
}

/// The brightest row of the image's middle, as a share of its height.
double brightest_row(const ColorImage& image) {
  int brightest = 0;
  int most = -1;
  for (int row = 0; row < image.height; ++row) {
    int sum = 0;
    for (int column = image.width / 2 - 4; column < image.width / 2 + 4; ++column)
      sum += image.rgb[3 * static_cast<std::size_t>(row * image.width + column)];
    if (sum > most) brightest = row;
    most = std::max(most, sum);
  }
  return static_cast<double>(brightest) / image.height;
}

TEST_F(SceneCommand, TheImageHasTheSizeOfTheScenesProbe) {
  const std::string body = kCamera +
                           "name: \"deep\" effects { solid { name: \"bone\" polish: \"tr 0 -0.04 0 sphere 0.01\" "
                           "echo { impedance_MRayl: 6 } } } ";
  struct Case {
    const char* probe;
    double depth_m;
  };
  for (const Case& c : {Case{"", 0.1}, Case{"probe {}", 0.1}, Case{"probe { depth_m: 0.05 width_m: 0.04 }", 0.05},
                        Case{"probe { depth_m: 0.2 }", 0.2}}) {
    const std::string scene = written(file("probe.textproto"), body + c.probe);
    const Outcome done = run({"image", scene, "--out", file("image.png")});
    ASSERT_EQ(done.code, 0) << done.err;
    const auto image = images::read_color_image(file("image.png"));
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    EXPECT_NEAR(brightest_row(*image), 0.03 / c.depth_m, 0.02) << c.probe << ": the ball's top is 30 mm deep";
  }
}

/// The number of pixels of a colour that stands in the legend, in the picture itself.
int seen(const ColorImage& image, const images::Rgb& rgb) {
  int count = 0;
  constexpr int kFirstRow = 80;  // below the title and the word "head"
  constexpr int kLastRow = 515;  // above the scale
  for (int row = kFirstRow; row < kLastRow; ++row)
    for (int column = 20; column < image.width - 20; ++column) {
      const auto at = 3 * static_cast<std::size_t>(row * image.width + column);
      int off = 0;
      for (std::size_t i = 0; i < 3; ++i) off = std::max(off, std::abs(image.rgb[at + i] - rgb[i]));
      count += off <= 2 ? 1 : 0;
    }
  return count;
}

TEST_F(SceneCommand, ShowDrawsSkinAndObjectsOfAnyKind) {
  constexpr images::Rgb kSkin{246, 221, 203};
  constexpr images::Rgb kGrid{228, 200, 180};
  for (const char* name : {"skin", "calibration", "palpation", "sphere", "regions", "mass-search"}) {
    const Outcome done = run({"show", name, "--out", file("picture.png")});
    ASSERT_EQ(done.code, 0) << done.err;
    const auto image = images::read_color_image(file("picture.png"));
    ASSERT_TRUE(image.ok()) << to_string(image.error());
    const int flat = seen(*image, kSkin) + seen(*image, kGrid);
    const int all = (image->width - 40) * (515 - 80);
    const bool is_skin_alone = std::string_view(name) == "skin" || std::string_view(name) == "calibration";
    EXPECT_GT(flat, all / 4) << name;
    EXPECT_TRUE(is_skin_alone ? flat > all - 500 : flat < all - 1500) << name << ": " << flat << " of " << all;
  }
}

TEST_F(SceneCommand, ShowDrawsEachObjectOfEachSceneThatShips) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (!entry.path().string().ends_with(".scene.textproto")) continue;
    const Result<scenes::Scene> scene = scenes::read_scene(entry.path());
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    const auto objects = std::ranges::count_if(scene->effects, [](const effects::Recipe& recipe) {
      return !std::holds_alternative<effects::SkinSettings>(recipe) &&
             !std::holds_alternative<effects::FrictionSettings>(recipe);
    });
    EXPECT_GE(static_cast<std::ptrdiff_t>(scenes::objects_of(*scene).size()), objects) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 15);
}

TEST_F(SceneCommand, ShowIsToScale) {
  const std::string scene =
      written(file("ball.textproto"), kCamera +
                                          "name: \"ball\" effects { sphere { center_m { x: 0.3 y: "
                                          "-0.05 } radius_m: 0.03 } }");
  ASSERT_EQ(run({"show", scene, "--width-m", "0.2", "--out", file("ball.png")}).code, 0);
  const auto image = images::read_color_image(file("ball.png"));
  ASSERT_TRUE(image.ok());
  constexpr int kPictureWidth_px = 512;
  int widest = 0;
  for (int row = 80; row < 540; ++row) {
    int drawn = 0;
    for (int column = 20; column < image->width - 20; ++column) {
      const auto at = 3 * static_cast<std::size_t>(row * image->width + column);
      drawn += image->rgb[at + 2] < 140 ? 1 : 0;  // orange has little blue, skin and grid have much
    }
    widest = std::max(widest, drawn);
  }
  EXPECT_NEAR(widest * 0.2 / kPictureWidth_px, 0.06, 0.001);
}

/// Dark pixels in the margin to the right of title and legend: text that is cut off.
int cut_off(const ColorImage& image) {
  int dark = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = image.width - 8; column < image.width; ++column) {
      const auto at = 3 * static_cast<std::size_t>(row * image.width + column);
      dark += image.rgb[at] < 100 ? 1 : 0;
    }
  return dark;
}

TEST_F(SceneCommand, ShowWritesTitleAndLegendWhole) {
  const std::string scene =
      written(file("long.textproto"),
              kCamera + "name: \"a_scene_with_a_name_that_is_longer_than_the_picture_is_wide\" purpose: \"" +
                  std::string(150, 'w') +
                  "\" effects { skin { tissue: \"relaxed_belly\" anchor: ANCHOR_SLIDING } } effects { "
                  "friction {} } effects { solid { name: \"a layer whose name does not fit into one line of the legend "
                  "at all\" "
                  "polish: \"tr 0 -0.05 0 sphere 0.01\" } }");
  for (const std::string& shown : {scene, std::string("skin_sliding"), std::string("palpation")}) {
    ASSERT_EQ(run({"show", shown, "--out", file("long.png")}).code, 0);
    const auto image = images::read_color_image(file("long.png"));
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(cut_off(*image), 0) << shown;
  }
}

TEST_F(SceneCommand, ShowTakesEachSide) {
  for (const char* side : {"above", "feet", "side"})
    EXPECT_EQ(run({"show", kMass, "--from", side, "--out", file("picture.png")}).code, 0) << side;
}

TEST_F(SceneCommand, MeshIsWatertightInBothFormats) {
  for (const char* name : {"mass.ply", "mass.obj"}) {
    const Outcome done = run({"mesh", kMass, "--layer", "mass", "--out", file(name)});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_NE(done.out.find("mesh of layer mass: closed, 1 part, Euler number 2, 4.1"), std::string::npos) << done.out;
    EXPECT_GT(std::filesystem::file_size(file(name)), 1000U);
  }
}

TEST_F(SceneCommand, APipeIsRefusedAndALinkReplacedByThePicture) {
  ASSERT_EQ(::mkfifo(file("pipe.png").c_str(), 0600), 0);
  const Outcome refused = run({"show", kMass, "--out", file("pipe.png")});
  EXPECT_EQ(refused.code, 1);
  EXPECT_NE(refused.err.find("pipe.png: is a folder, device, pipe or socket"), std::string::npos) << refused.err;
  std::filesystem::create_symlink(written(file("mine.txt"), "mine"), file("link.png"));
  EXPECT_EQ(run({"show", kMass, "--out", file("link.png")}).code, 0);
  EXPECT_FALSE(std::filesystem::is_symlink(file("link.png")));
  EXPECT_EQ(std::filesystem::file_size(file("mine.txt")), 4U);
}

struct Wrong {
  std::vector<std::string> words;
  int code;
  std::string what;
};

TEST_F(SceneCommand, SaysWhatIsWrongAndWritesNothing) {
  const std::string out = file("x.png");
  const std::string torn = written(file("torn.textproto"), "name: \"torn\" effects { solid { name: \"a\" polish: ");
  const std::string unknown =
      written(file("unknown.textproto"), kCamera + "name: \"u\" effects { solid { name: \"a\" polish: \"orb 1\" } }");
  const std::string itself =
      written(file("itself.textproto"),
              kCamera + "name: \"i\" effects { solid { name: \"a\" polish_file: \"itself.textproto\" } }");
  const Wrong kWrongs[] = {
      {{"check", file("none.textproto")}, 1, "none.textproto"},
      {{"check", torn}, 1, "torn.textproto"},
      {{"show", unknown, "--out", out}, 1, "a: expected a solid, found 'orb'"},
      {{"show", itself, "--out", out}, 1, "found 'haptic_from_camera'"},
      {{"show", kMass}, 2, "--out: the file to write is not named"},
      {{"show", kMass, "--out", file("x.jpg")}, 2, "x.jpg' does not end in .png"},
      {{"show", kMass, "--from", "below", "--out", out}, 2, "'below' is not one of above, feet and side"},
      {{"show", kMass, "--width-m", "-1", "--out", out}, 2, "--width-m"},
      {{"image", kMass, "--at", "1;2", "--out", out}, 2, "--at"},
      {{"image", kMass, "--turn-deg", "nan", "--out", out}, 2, "--turn-deg"},
      {{"mesh", kMass, "--cell-mm", "0", "--out", file("x.ply")}, 2, "--cell-mm"},
      {{"mesh", kMass, "--layer", "spleen", "--out", file("x.ply")}, 1, "no layer 'spleen'"},
      {{"mesh", kMass, "--out", file("x.stl")}, 2, "x.stl' does not end in .ply or .obj"},
      {{"mesh", kMass, "--out", file("none/x.ply")}, 1, "cannot be written"},
      {{"paint", kMass}, 2, ""},
      {{"check"}, 2, "a task and one scene are needed"},
  };
  for (const Wrong& wrong : kWrongs) {
    const Outcome done = run(wrong.words);
    EXPECT_EQ(done.code, wrong.code) << done.err;
    EXPECT_NE(done.err.find(wrong.what), std::string::npos) << wrong.what << " in: " << done.err;
    EXPECT_NE(done.err.find("fix:"), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(out)) << done.err;
  }
}

}  // namespace
}  // namespace telepalp::station
