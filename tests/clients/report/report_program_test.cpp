// telepalp-report as its users run it, and the session files that it reads.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/clients/report/made_report.h"
#include "where.h"

namespace telepalp::report {
namespace {

TEST(SessionFile, WithoutACameraThereIsNoFrameAndNoError) {
  const auto file = written({.seconds = 1.0, .with_camera = false}, "report_no_camera.mcap");
  const auto session = read_session(file);
  ASSERT_TRUE(session.ok());
  const auto frame = read_frame(file, *session, kMadeStart_ns);
  ASSERT_TRUE(frame.ok());
  EXPECT_FALSE(frame->has_value());
}

TEST(SessionFile, OneThatWasCutOffSaysHowToRepairIt) {
  const auto file = written({.seconds = 1.0}, "report_cut.mcap");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  const auto session = read_session(file);
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("telepalp-record repair"), std::string::npos) << to_string(session.error());
}

TEST(SessionFile, AnEmptyOneIsAnErrorThatSaysSo) {
  const auto file = written({.seconds = 0.0, .with_station = false, .with_camera = false}, "report_empty.mcap");
  const auto session = read_session(file);
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("holds no message"), std::string::npos) << to_string(session.error());
}

TEST(SessionFile, OneThatIsNotThereIsAnError) {
  const auto session = read_session("/no/such/session.mcap");
  ASSERT_FALSE(session.ok());
  EXPECT_NE(to_string(session.error()).find("/no/such/session.mcap"), std::string::npos);
}

std::string output_of(const std::string& command, int& code) {
  std::string text;
  std::array<char, 512> block{};
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  while (std::fgets(block.data(), static_cast<int>(block.size()), pipe) != nullptr) text += block.data();
  code = WEXITSTATUS(::pclose(pipe));
  return text;
}

const std::string kProgram = std::string(TELEPALP_BINARY_DIR) + "/bin/telepalp-report ";

TEST(Program, WritesItsThreeFiles) {
  const auto file = written({.seconds = 2.0}, "report_program.mcap");
  const std::filesystem::path out = std::filesystem::path(::testing::TempDir()) / "report_program_out";
  std::filesystem::remove_all(out);
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 0) << said;
  for (const char* name : {"report.json", "report.html", "view.png"})
    EXPECT_GT(std::filesystem::file_size(out / name), 1000U) << name;
  std::stringstream png;
  png << std::ifstream(out / "view.png", std::ios::binary).rdbuf();
  EXPECT_EQ(png.str().substr(1, 3), "PNG");
}

std::filesystem::path fresh_folder(const std::string& name);

TEST(Program, TakesAFolderWithASessionAndNamesTheSessionsOfAnother) {
  const std::filesystem::path replayed = fresh_folder("report_replayed"), out = fresh_folder("report_replayed_out");
  std::filesystem::create_directories(replayed);
  const auto file = written({.seconds = 1.0, .with_camera = false}, "report_of_folder.mcap");
  std::filesystem::rename(file, replayed / "session.mcap");
  int code = -1;
  std::string said = output_of(kProgram + replayed.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 0) << said;
  EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
  std::filesystem::rename(replayed / "session.mcap", replayed / "monday.mcap");
  said = output_of(kProgram + replayed.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 1);
  EXPECT_NE(said.find("the folder holds no session.mcap, but monday.mcap. fix: name a session file"), std::string::npos)
      << said;
}

/// A new folder for one run of the program.
std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  return folder;
}

std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

TEST(Program, ShowsTheNotesBesideTheSessionWithTimeAndWriter) {
  const auto file = written({.seconds = 1.5, .with_camera = false}, "report_noted.mcap");
  const std::filesystem::path notes = file.string() + ".notes.json", out = fresh_folder("report_noted_out");
  std::ofstream(notes) << R"({"notes": [{"number": "7", "at_s": 1.25, "text": "rebound here & there",)"
                       << R"json( "who": "Ada (qa)", "written": "2026-03-01T12:00:00Z"}], "last_number": "7"})json";
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  ASSERT_EQ(code, 0) << said;
  const std::string html = text_of(out / "report.html"), json = text_of(out / "report.json");
  EXPECT_NE(html.find("<td>1.25 s</td><td>rebound here &amp; there</td><td>Ada (qa)</td><td>2026-03-01T12:00:00Z</td>"),
            std::string::npos);
  for (const char* member : {R"("at_s": 1.25)", R"("text": "rebound here & there")", R"json("who": "Ada (qa)")json"})
    EXPECT_NE(json.find(member), std::string::npos) << member;
  std::filesystem::remove(notes);
}

TEST(Program, WithoutNotesHasNoSuchSectionAndAnEmptyList) {
  const auto file = written({.seconds = 1.0, .with_camera = false}, "report_not_noted.mcap");
  const std::filesystem::path out = fresh_folder("report_not_noted_out");
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  ASSERT_EQ(code, 0) << said;
  EXPECT_EQ(text_of(out / "report.html").find("<h2>Notes"), std::string::npos);
  EXPECT_NE(text_of(out / "report.json").find("\"notes\": []"), std::string::npos) << text_of(out / "report.json");
}

TEST(Program, NamesAFileOfNotesThatItCannotRead) {
  const auto file = written({.seconds = 1.0}, "report_badly_noted.mcap");
  const std::filesystem::path notes = file.string() + ".notes.json";
  std::ofstream(notes) << R"({"notes": 3})";
  int code = -1;
  const std::string said =
      output_of(kProgram + file.string() + " --out " + fresh_folder("report_badly").string(), code);
  EXPECT_EQ(code, 1);
  EXPECT_NE(said.find("report_badly_noted.mcap.notes.json"), std::string::npos) << said;
  EXPECT_NE(said.find("fix:"), std::string::npos) << said;
  std::filesystem::remove(notes);
}

std::filesystem::perms mode_of(const std::filesystem::path& file) {
  return std::filesystem::symlink_status(file).permissions();
}

TEST(Program, KeepsWhatShowsThePatientFromOthersAndWritesThroughNoPlantedLink) {
  const auto file = written({.seconds = 1.0}, "report_private.mcap");
  const std::filesystem::path top = fresh_folder("report_private_out"), out = top / "new";
  const std::string command = "umask 022; " + kProgram + file.string() + " --out " + out.string();
  int code = -1;
  std::string said = output_of(command, code);
  ASSERT_EQ(code, 0) << said;
  EXPECT_EQ(mode_of(out), std::filesystem::perms{0750});
  for (const char* name : {"report.json", "report.html", "view.png"}) {
    EXPECT_EQ(mode_of(out / name), std::filesystem::perms{0640}) << name;
    std::filesystem::remove(out / name);
    std::filesystem::create_symlink(top / "victim", out / name);
  }
  said = output_of(command, code);
  ASSERT_EQ(code, 0) << said;
  EXPECT_FALSE(std::filesystem::exists(top / "victim"));
}

TEST(Program, FinishesASessionWhoseRecorderWasCutOffAndSaysSo) {
  const auto file = written({.seconds = 2.0}, "report_unfinished.mcap");
  const std::filesystem::path partial = file.string() + ".partial";
  std::filesystem::rename(file, partial);
  std::filesystem::resize_file(partial, std::filesystem::file_size(partial) * 3 / 4);
  const std::filesystem::path out = fresh_folder("report_unfinished_out");
  int code = -1;
  const std::string said = output_of(kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 0) << said;
  EXPECT_NE(said.find("was not completed by its recorder; the file is complete now"), std::string::npos) << said;
  EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
  EXPECT_TRUE(read_session(file).ok());
  EXPECT_FALSE(std::filesystem::exists(partial));
}

TEST(Program, OnAFullDiskSaysSoAndLeavesNoHalfReport) {
  const auto file = written({.seconds = 2.0}, "report_full.mcap");
  const std::filesystem::path out = fresh_folder("report_full_out");
  int code = -1;
  const std::string said =
      output_of("trap '' XFSZ; ulimit -f 40; " + kProgram + file.string() + " --out " + out.string(), code);
  EXPECT_EQ(code, 1) << said;
  EXPECT_NE(said.find("fix: free space"), std::string::npos) << said;
  for (const char* name : {"report.html", "view.png"}) EXPECT_FALSE(std::filesystem::exists(out / name)) << name;
}

TEST(Program, SaysWhatIsWrongAndLeavesWithItsCode) {
  int code = -1;
  EXPECT_NE(output_of(kProgram, code).find("fix:"), std::string::npos);
  EXPECT_EQ(code, 2);
  EXPECT_NE(output_of(kProgram + "/no/such/session.mcap", code).find("fix:"), std::string::npos);
  EXPECT_EQ(code, 1);
}

}  // namespace
}  // namespace telepalp::report
