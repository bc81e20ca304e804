// The main use of telepalp as a user runs it: deploy/demo --headless starts the real programs on loopback and writes
// four files. The test reads them like another program would.

#include <gtest/gtest.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "where.h"

namespace {

namespace fs = std::filesystem;
using Json = boost::property_tree::ptree;

struct DemoRun {
  int exit_code = -1;
  fs::path out;
  std::string log;
};

std::string read_all(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs `deploy/demo ARGUMENTS --out DIR` with the programs of this build.
DemoRun demo(const std::string& name, const std::string& arguments) {
  DemoRun run;
  run.out = fs::temp_directory_path() / ("telepalp_demo_" + name);
  fs::remove_all(run.out);
  fs::create_directories(run.out);
  const std::string log = (run.out / "log").string();
  const std::string command = "cd " TELEPALP_SOURCE_DIR " && TELEPALP_BIN=" TELEPALP_BINARY_DIR "/bin deploy/demo " +
                              arguments + " --out '" + run.out.string() + "' >" + log + " 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.log = read_all(log);
  return run;
}

Json report_of(const DemoRun& run) {
  Json json;
  std::ifstream stream(run.out / "report.json");
  boost::property_tree::read_json(stream, json);
  return json;
}

double figure(const Json& json, const std::string& path) { return json.get<double>(path); }

struct SourceCase {
  std::string name;
  std::string source;
  friend std::ostream& operator<<(std::ostream& out, const SourceCase& test) { return out << test.name; }
};

class Demo : public ::testing::TestWithParam<SourceCase> {};

TEST_P(Demo, RunsUnattendedAndWritesFourFilesAboutTheRun) {
  const DemoRun run = demo(GetParam().name, "--headless --seconds 10 --source " + GetParam().source);
  ASSERT_EQ(run.exit_code, 0) << run.log;
  for (const char* file : {"session.mcap", "report.html", "report.json", "view.png"})
    EXPECT_GT(fs::file_size(run.out / file), 1000u) << file;
  const Json json = report_of(run);
  EXPECT_TRUE(json.get<std::string>("server_software").starts_with("telepalp-server "));
  EXPECT_TRUE(json.get<std::string>("station_software").starts_with("telepalp-station "));
  EXPECT_GE(figure(json, "ticks") + figure(json, "deadlines_missed"), 19'000.0);
  EXPECT_LE(figure(json, "tick_us.p50"), figure(json, "tick_us.p99"));
  EXPECT_LE(figure(json, "tick_us.p99"), figure(json, "tick_us.p999"));
  EXPECT_GT(figure(json, "frames.sent"), 0.0);
  EXPECT_GT(figure(json, "frames.received"), 0.0);
  EXPECT_GT(figure(json, "latency_ms.capture_to_touchable.p50"), 0.0);
  EXPECT_LE(figure(json, "latency_ms.capture_to_touchable.p50"), figure(json, "latency_ms.capture_to_touchable.p99"));
  EXPECT_GE(figure(json, "force_N.max"), 0.0);
  EXPECT_LE(figure(json, "force_N.max"), 10.0);
}

INSTANTIATE_TEST_SUITE_P(Sources, Demo,
                         ::testing::Values(SourceCase{"synthetic", "synthetic"},
                                           SourceCase{"oni", "oni:deploy/demo_data/oni/3dj_test.oni"}),
                         [](const auto& test) { return test.param.name; });

TEST(SyntheticPatient, IsTouchedAndLetGoOf) {
  const DemoRun run = demo("touch", "--headless --seconds 10");
  ASSERT_EQ(run.exit_code, 0) << run.log;
  const Json json = report_of(run);
  EXPECT_GE(figure(json, "states.in_body.entries"), 1.0);
  EXPECT_GE(figure(json, "states.out_body.entries"), 1.0);
  EXPECT_GT(figure(json, "contact_s"), 0.5);
  EXPECT_GT(figure(json, "force_N.max"), 0.2);
}

TEST(TemporalDepth, IsRecordedReportedPlayedAgainAndReportedAgain) {
  const DemoRun first = demo("temporal", "--headless --seconds 6 --depth-mode temporal");
  ASSERT_EQ(first.exit_code, 0) << first.log;
  EXPECT_EQ(report_of(first).get<std::string>("depth_mode"), "temporal");
  EXPECT_NE(first.log.find("depth is lossless (depth mode temporal)"), std::string::npos);
  const DemoRun again = demo("again", "--headless --seconds 4 --depth-mode temporal --source session:" +
                                          (first.out / "session.mcap").string());
  ASSERT_EQ(again.exit_code, 0) << again.log;
  const Json json = report_of(again);
  EXPECT_EQ(json.get<std::string>("depth_mode"), "temporal");
  EXPECT_GT(figure(json, "frames.received"), 60.0);
  EXPECT_GT(fs::file_size(again.out / "view.png"), 100'000u) << "a frame in the midst of a group was drawn";
}

TEST(BoundedDepth, IsWarnedOfAtTheStationAndInTheReport) {
  const DemoRun run = demo("bounded", "--headless --seconds 3 --depth-mode bounded --depth-bound 2,4");
  ASSERT_EQ(run.exit_code, 0) << run.log;
  EXPECT_NE(run.log.find("bounded, off by up to 4 mm at 1 m; such depth is for pictures, not for touch"),
            std::string::npos);
  const Json json = report_of(run);
  EXPECT_EQ(json.get<std::string>("depth_mode"), "bounded");
  EXPECT_EQ(figure(json, "depth_bound_mm.per_m2"), 4.0);
  std::string causes;
  for (const auto& [key, cause] : json.get_child("verdict.causes")) causes += cause.get<std::string>("what") + "\n";
  EXPECT_NE(causes.find("bounded, off by up to 4 mm"), std::string::npos) << causes;
}

struct WrongCase {
  std::string name;
  std::string arguments;
  int exit_code;
  std::string says;  ///< text that the message must contain
  friend std::ostream& operator<<(std::ostream& out, const WrongCase& test) { return out << test.name; }
};

class WronglyAsked : public ::testing::TestWithParam<WrongCase> {};

TEST_P(WronglyAsked, SaysWhatAndHowToFixAndWritesNoSession) {
  const DemoRun run = demo("wrong_" + GetParam().name, "--headless --seconds 2 " + GetParam().arguments);
  EXPECT_EQ(run.exit_code, GetParam().exit_code) << run.log;
  EXPECT_NE(run.log.find(GetParam().says), std::string::npos) << run.log;
  EXPECT_NE(run.log.find("fix:"), std::string::npos) << run.log;
  EXPECT_FALSE(fs::exists(run.out / "session.mcap"));
}

INSTANTIATE_TEST_SUITE_P(Cases, WronglyAsked,
                         ::testing::Values(WrongCase{"no_such_file", "--source oni:nowhere.oni", 1, "nowhere.oni"},
                                           WrongCase{"not_an_oni", "--source oni:README.md", 1, "README.md"},
                                           WrongCase{"no_such_source", "--source kinect9", 1, "kinect9"},
                                           WrongCase{"unknown_option", "--sauce synthetic", 2, "--sauce"},
                                           WrongCase{"not_a_number", "--http-port soon", 2, "soon"},
                                           WrongCase{"given_twice", "--seconds 3", 2, "given twice"},
                                           WrongCase{"no_such_hand", "--hand left", 2, "left"},
                                           WrongCase{"no_such_scene", "--scene nowhere.textproto", 1,
                                                     "nowhere.textproto"}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
