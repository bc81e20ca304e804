#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <utility>

#include "server/capture/capture_source.h"
#include "server/capture/oni/depth_16z.h"
#include "server/capture/oni/recording.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::capture {
namespace {

namespace fs = std::filesystem;

const std::string kShipped = TELEPALP_SOURCE_DIR "/deploy/demo_data/oni/3dj_test.oni";

const std::string& shipped_bytes() {
  static const std::string bytes = [] {
    std::ifstream stream(kShipped, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  }();
  return bytes;
}

void expect_said(const Error& error, const std::string& about) {
  EXPECT_FALSE(error.what.empty()) << about;
  EXPECT_FALSE(error.where.empty()) << about;
  EXPECT_FALSE(error.fix.empty()) << about;
}

/// Expects frames, or an error with what, where and fix. Decodes only the first depth image.
void expect_played_or_said(const std::string& bytes, const std::string& about) {
  std::istringstream file(bytes);
  const Result<OniRecording> recording = read_oni_recording(file, "a.oni");
  if (!recording) return expect_said(recording.error(), about);
  const auto depth = read_oni_depth(file, recording->depth, recording->depth.images.front(), "a.oni");
  if (!depth) return expect_said(depth.error(), about);
  EXPECT_TRUE(is_well_formed(*depth)) << about;
}

TEST(OniRecording, EveryDamagedByteOfTheHeadGivesFramesOrSaysWhatWhereAndHowToFixIt) {
  std::string bytes = shipped_bytes().substr(0, 210'000);  // up to the first depth image: quicker
  for (std::size_t at = 0; at < 2000; ++at) {
    const char was = std::exchange(bytes[at], static_cast<char>(~bytes[at]));
    expect_played_or_said(bytes, "byte " + std::to_string(at) + " inverted");
    bytes[at] = was;
  }
}

TEST(OniRecording, FlippedBitsAndCutsAnywhereGiveFramesOrSayWhatWhereAndHowToFixIt) {
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> place(0, shipped_bytes().size() - 1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t at = place(random);
    std::string bytes = shipped_bytes();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << (i % 8)));
    expect_played_or_said(bytes, "a bit of byte " + std::to_string(at) + " flipped");
    expect_played_or_said(shipped_bytes().substr(0, at), "cut at byte " + std::to_string(at));
  }
}

TEST(OniRecording, ADamagedImageCostsItselfAloneAndTheComplaintNamesItsByte) {
  std::string bytes = shipped_bytes();
  bytes[274653] = 'X';  // the mark of the record that holds the second depth image
  std::istringstream file(bytes);
  const auto recording = read_oni_recording(file, "a.oni");
  ASSERT_TRUE(recording.ok()) << to_string(recording.error());
  EXPECT_EQ(recording->depth.images.size(), 11U);
  EXPECT_NE(recording->complaint.find("byte 274653 of 2124474"), std::string::npos) << recording->complaint;
}

TEST(OniRecording, AWholeRecordingHasNothingToComplainOf) {
  std::istringstream file(shipped_bytes());
  const auto recording = read_oni_recording(file, "a.oni");
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(recording->complaint, "");
  EXPECT_EQ(recording->depth.images.size(), 12U);
  EXPECT_EQ(recording->color.images.size(), 12U);
}

template <std::size_t N>
std::span<const std::byte> bytes_of(const std::array<unsigned char, N>& packet) {
  return std::as_bytes(std::span(packet));
}

using Samples = std::vector<std::uint16_t>;

TEST(OniDepth, DifferencesAreDecodedInEachOfTheirSizes) {
  // 800, then 800 - 5 in a byte, four times the same, 795 - 0 and a whole 900 in one byte's halves, 900 + 1 alone.
  const std::array<unsigned char, 10> packet{0x20, 0x03, 0xFF, 0xC5, 0xE2, 0x6F, 0x03, 0x84, 0x5D, 0xE0};
  EXPECT_EQ(decode_16z(bytes_of(packet), 9), (Samples{800, 795, 795, 795, 795, 795, 795, 900, 901}));
  EXPECT_FALSE(decode_16z(bytes_of(packet), 8)) << "one sample too many";
  EXPECT_FALSE(decode_16z(bytes_of(packet), 10)) << "one sample too few";
  for (std::size_t cut = 0; cut < 9; ++cut) EXPECT_FALSE(decode_16z(bytes_of(packet).first(cut), 9)) << cut;
}

TEST(OniDepth, AnIndexBeyondTheTableIsRefused) {
  std::array<unsigned char, 9> packet{2, 0, 0x20, 0x03, 0x84, 0x03, 0, 0, 0x5D};
  EXPECT_EQ(decode_16z_table(bytes_of(packet), 2), (Samples{800, 900}));
  packet[8] = 0x4D;  // index 2 of two values
  EXPECT_FALSE(decode_16z_table(bytes_of(packet), 2));
  packet[0] = 200;  // a table longer than the packet
  EXPECT_FALSE(decode_16z_table(bytes_of(packet), 2));
}

SourceOptions unpaced(bool loop) { return {.clock = wire::SessionClock{Nanoseconds{0}}, .loop = loop, .paced = false}; }

TEST(OniSource, ARecordingThatIsCutWhileItPlaysEndsAndSaysWhere) {
  const support::TemporaryFolder folder;
  const fs::path file = folder.path() / "cut.oni";
  std::ofstream(file, std::ios::binary) << shipped_bytes();
  const auto source = open_source("oni:" + file.string(), unpaced(true));
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  for (int i = 0; i < 3; ++i) ASSERT_TRUE((*source)->next(Nanoseconds{0}));
  fs::resize_file(file, 50'000);
  for (int i = 0; i < 40; ++i) (void)(*source)->next(Nanoseconds{0});
  EXPECT_EQ((*source)->state(), CaptureState::Ended);
  EXPECT_NE((*source)->complaint().find("at byte"), std::string::npos) << (*source)->detail();
}

TEST(OniSource, ARecordingThatIsOverwrittenWhileItPlaysGivesWholeFramesOrNone) {
  const support::TemporaryFolder folder;
  const fs::path file = folder.path() / "spoilt.oni";
  std::ofstream(file, std::ios::binary) << shipped_bytes();
  const auto source = open_source("oni:" + file.string(), unpaced(true));
  ASSERT_TRUE(source.ok()) << to_string(source.error());
  ASSERT_TRUE((*source)->next(Nanoseconds{0}));
  std::fstream spoil(file, std::ios::binary | std::ios::in | std::ios::out);
  for (std::size_t at = 30'000; at < shipped_bytes().size(); at += 5'000) {
    spoil.seekp(static_cast<std::streamoff>(at));
    spoil << "spoilt";
  }
  spoil.close();
  for (int i = 0; i < 40; ++i) {
    const auto frame = (*source)->next(Nanoseconds{0});
    EXPECT_TRUE(!frame || is_well_formed(*frame));
  }
  EXPECT_NE((*source)->complaint().find("damaged at byte"), std::string::npos) << (*source)->detail();
}

TEST(OniSource, AFileIsNeverGivenToOpenNisOwnPlayer) {
  const auto source = open_source("openni2:" + kShipped, unpaced(false));
  ASSERT_FALSE(source.ok());
  EXPECT_NE(source.error().fix.find("oni:" + kShipped), std::string::npos) << to_string(source.error());
}

TEST(CodecProgram, ADamagedRecordingIsRefusedOrEncodedWithANoteAndLeavesNothingHalfDone) {
  const support::TemporaryFolder folder;
  const auto encode = [&](const std::string& bytes) {
    std::ofstream(folder.path() / "in.oni", std::ios::binary) << bytes;
    return support::ChildProcess(TELEPALP_BINARY_DIR "/bin/telepalp-codec",
                                 {"encode", folder.path() / "in.oni", folder.path() / "out.mcap"},
                                 folder.path() / "log")
        .wait(std::chrono::seconds(60))
        .value_or(-1);
  };
  const auto log = [&] {
    std::ifstream stream(folder.path() / "log");
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  EXPECT_EQ(encode(shipped_bytes().substr(0, 1'000'000)), 0);
  EXPECT_NE(log().find("cut off at byte 1000000"), std::string::npos) << log();
  fs::remove(folder.path() / "out.mcap");
  EXPECT_EQ(encode(shipped_bytes().substr(0, 90'000)), 1);
  EXPECT_NE(log().find("it has no depth image"), std::string::npos) << log();
  for (const auto& entry : fs::directory_iterator(folder.path()))
    EXPECT_TRUE(entry.path().filename() == "in.oni" || entry.path().filename() == "log") << entry.path();
}

}  // namespace
}  // namespace telepalp::capture
