// Folders of images, the board, and telepalp-mixed as its users run it.

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <fstream>
#include <numbers>

#include "clients/mixed/files/anchor_touches.h"
#include "clients/mixed/files/image_sequence.h"
#include "clients/mixed/files/marker_board.h"
#include "clients/mixed/files/rendered_sequence.h"
#include "proto/words/numbers/number_row.h"
#include "proto/words/rotation_vector.h"
#include "support/images/image_file.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::mixed {
namespace {

namespace fs = std::filesystem;

/// A rendered sequence of few images, made once.
const fs::path& rendered() {
  static const support::TemporaryFolder folder;
  static const bool written = write_rendered_sequence(folder.path(), 4, 2, 0.02, ProxyKind::Planes).ok();
  EXPECT_TRUE(written);
  return folder.path();
}

/// A copy of the rendered folder in which one table is replaced.
fs::path with_table(const support::TemporaryFolder& folder, const std::string& name, const std::string& text) {
  fs::copy(rendered(), folder.path(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  std::ofstream(folder.path() / name) << text;
  return folder.path();
}

std::string says(const fs::path& folder) {
  const Result<ImageSequence> sequence = read_sequence(folder);
  return sequence ? "" : to_string(sequence.error());
}

TEST(ImageSequence, ReadsBackWhatWasRendered) {
  const Result<ImageSequence> sequence = read_sequence(rendered());
  ASSERT_TRUE(sequence) << to_string(sequence.error());
  EXPECT_EQ(sequence->background.size(), 4U);
  ASSERT_EQ(sequence->frames.size(), 2U);
  EXPECT_EQ(sequence->frames[0].joints_rad.size(), 6U);
  EXPECT_GT(sequence->proxy.triangles.size(), 500U);
  EXPECT_NEAR(sequence->device.world_from_haptic.iso.translation().y(), 0.22, 1e-6);
  EXPECT_TRUE(read_frame(sequence->frames[0].image.file, sequence->lens));
}

TEST(ImageSequence, ASentenceEachForWhatCannotBeUsed) {
  const support::TemporaryFolder a, b, c, d;
  EXPECT_NE(says("/no/such/folder").find("cannot be read"), std::string::npos);
  const std::string one = std::string(kBackgroundHeader) + "\nbackground_000.png,0,0,1,0,0,0\n";
  EXPECT_NE(says(with_table(a, "background.csv", one)).find("has 1 images"), std::string::npos);
  const std::string cut = std::string(kBackgroundHeader) + "\nbackground_000.png,0,0,1,0,0,0\nbackground_001.png,0,0";
  EXPECT_NE(says(with_table(b, "background.csv", cut)).find("background.csv:3: the row"), std::string::npos);
  EXPECT_NE(says(with_table(c, "frames.csv", "time\n1\n")).find("frames.csv:1: the first line"), std::string::npos);
  EXPECT_NE(says(with_table(d, "camera.csv", std::string(kCameraHeader) + "\n")).find("no row"), std::string::npos);
}

TEST(ImageSequence, AnImageOfAnotherSizeThanTheIntrinsicsIsRefused) {
  const Result<ColorImage> image = read_frame(rendered() / "live_000.png", {320, 240, 300, 300, 160, 120});
  ASSERT_FALSE(image);
  EXPECT_NE(image.error().what.find("640 x 480"), std::string::npos) << image.error().what;
}

/// The bits of a marker, turned by 90 degrees.
std::uint16_t turned(std::uint16_t bits) {
  std::uint16_t out = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x)
      if ((bits >> (15 - (4 * y + x)) & 1) != 0) out = static_cast<std::uint16_t>(out | 1U << (15 - (4 * x + 3 - y)));
  return out;
}

TEST(MarkerBoard, NoMarkerTurnedAnyWayIsLikeAnother) {
  for (std::size_t i = 0; i < kMarkers.size(); ++i)
    for (std::size_t k = 0; k < kMarkers.size(); ++k) {
      std::uint16_t other = kMarkers[k];
      for (int turn = 0; turn < 4; ++turn, other = turned(other))
        if (i != k || turn != 0) {
          EXPECT_GE(std::bitset<16>(kMarkers[i] ^ other).count(), 3U) << i << " and " << k << " turned " << turn;
        }
    }
}

TEST(MarkerBoard, ListsFourCornersOfEachMarkerAroundTheMiddle) {
  const std::string table = board_table(30.0);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 24 * 4);
  EXPECT_NE(table.find("0,0,-0.105000,0.069000,0"), std::string::npos) << table.substr(0, 200);
  EXPECT_NE(table.find("23,2,0.105000,-0.069000,0"), std::string::npos);
}

int run(const std::vector<std::string>& arguments, const fs::path& log) {
  support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-mixed", arguments, log);
  return program.wait(std::chrono::seconds(120)).value_or(-1);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(MixedProgram, ComposesCalibratesAndWritesABoard) {
  const support::TemporaryFolder out;
  const fs::path log = out.path() / "log";
  ASSERT_EQ(run({"compose", "--images", rendered().string(), "--out", (out.path() / "mixed").string()}, log), 0)
      << text_of(log);
  EXPECT_NE(text_of(log).find("live_000.png: device hidden (1.00)"), std::string::npos) << text_of(log);
  EXPECT_TRUE(images::read_color_image(out.path() / "mixed" / "live_001.png"));
  ASSERT_EQ(run({"calibrate", "--clicks", (rendered() / "clicks.csv").string(), "--out",
                 (out.path() / "device.csv").string()},
                log),
            0);
  EXPECT_NE(text_of(log).find("36 clicks miss their rings by 1."), std::string::npos) << text_of(log);
  ASSERT_EQ(
      run({"anchor", "--touches", (rendered() / "touches.csv").string(), "--out", (out.path() / "anchor.csv").string()},
          log),
      0);
  EXPECT_NE(text_of(log).find("residual 1."), std::string::npos) << text_of(log);
  ASSERT_EQ(run({"board", "--out", (out.path() / "board.svg").string()}, log), 0);
  EXPECT_TRUE(fs::exists(out.path() / "board.csv"));
  EXPECT_EQ(run({"compose", "--images", "/no/such/folder"}, log), 1);
  EXPECT_NE(text_of(log).find("camera.csv: the file cannot be read. fix:"), std::string::npos) << text_of(log);
}

TEST(MixedProgram, FindsAGloveByAPictureOfItAndRevealsTheDeviceWithoutStatesOfTheStation) {
  const support::TemporaryFolder out, folder;
  const fs::path log = out.path() / "log";
  // One colour that the sequence does not have: no hand is found, so nothing is moved beside the device's mask.
  const ColorImage blue{8, 8, [] {
                          std::vector<std::uint8_t> rgb(8 * 8 * 3, 0);
                          for (std::size_t i = 2; i < rgb.size(); i += 3) rgb[i] = 255;
                          return rgb;
                        }()};
  std::ofstream(out.path() / "glove.png", std::ios::binary) << images::encode_png(blue);
  ASSERT_EQ(run({"compose", "--images", rendered().string(), "--out", (out.path() / "bare").string()}, log), 0);
  ASSERT_EQ(run({"compose", "--images", rendered().string(), "--out", (out.path() / "glove").string(), "--glove",
                 (out.path() / "glove.png").string()},
                log),
            0)
      << text_of(log);
  const auto live = images::read_color_image(rendered() / "live_001.png");
  const auto bare = images::read_color_image(out.path() / "bare" / "live_001.png");
  const auto glove = images::read_color_image(out.path() / "glove" / "live_001.png");
  ASSERT_TRUE(live && bare && glove);
  EXPECT_NE(bare->rgb, glove->rgb);
  const fs::path late = with_table(folder, "coupling.csv", std::string(kCouplingHeader) + "\n9,0,0,0,0,0,0\n");
  ASSERT_EQ(run({"compose", "--images", late.string(), "--out", (out.path() / "late").string()}, log), 0);
  EXPECT_NE(text_of(log).find("live_000.png: device visible (0.00)"), std::string::npos) << text_of(log);
  const support::TemporaryFolder other;
  EXPECT_NE(says(with_table(other, "coupling.csv", std::string(kCouplingHeader) + "\n1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n"))
                .find("coupling.csv:3: the row"),
            std::string::npos);
}

TEST(MixedProgram, AnchorsAHeadsetBySavedTouchesWithATurnedController) {
  const support::TemporaryFolder folder;
  const fs::path log = folder.path() / "log", touches = folder.path() / "touches.csv";
  // Turned by pi/2 about y; the controller's tip is 0.1 m along its z axis.
  std::ofstream table(touches);
  table << kTouchesHeader << "\n";
  const Eigen::Vector3d tip(0.0, 0.0, 0.1), rest(0.3, 1.0, -0.2);
  const auto row = [&](int place, const Eigen::Vector3d& known, const Eigen::Vector3d& at,
                       const Eigen::Vector3d& turn) {
    const Eigen::Vector3d origin = at - isometry_of(turn, Eigen::Vector3d::Zero()) * tip;
    table << place;
    for (const Eigen::Vector3d& v : {known, origin, turn}) table << "," << v.x() << "," << v.y() << "," << v.z();
    table << "\n";
  };
  for (int i = 0; i < 8; ++i) row(-1, {0, 0, 0}, rest, {0.5 * std::cos(i), 0.1, 0.5 * std::sin(i)});
  for (const Eigen::Vector3d& known :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.2, 0, 0), Eigen::Vector3d(0, 0, 0.25)})
    row(static_cast<int>(1e3 * known.sum()), known, Eigen::Vector3d(1.0 + known.z(), 2.0, 3.0 - known.x()),
        {0.2, 0.1, 0});
  table.close();
  ASSERT_EQ(run({"anchor", "--touches", touches.string(), "--out", (folder.path() / "a.csv").string()}, log), 0)
      << text_of(log);
  EXPECT_NE(text_of(log).find("mm from the tool's origin, residual 0.00 mm rms"), std::string::npos) << text_of(log);
  std::ifstream anchor(folder.path() / "a.csv");
  std::string row_text;
  std::getline(anchor, row_text);
  std::getline(anchor, row_text);
  const auto pose = number_row<7>(row_text);
  ASSERT_TRUE(pose) << row_text;
  for (const auto& [index, value] :
       {std::pair<std::size_t, double>{0, 1.0}, {1, 2.0}, {2, 3.0}, {4, 0.5 * std::numbers::pi}})
    EXPECT_NEAR((*pose)[index], value, 1e-4) << row_text;
  std::ofstream(touches) << kTouchesHeader << "\n0.5,0,0,0,0,0,0,0,0,0\n";
  EXPECT_EQ(run({"anchor", "--touches", touches.string()}, log), 1);
  EXPECT_NE(text_of(log).find("touches.csv:2: the row"), std::string::npos) << text_of(log);
}

}  // namespace
}  // namespace telepalp::mixed
