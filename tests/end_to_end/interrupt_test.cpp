// deploy/demo in a real terminal, ended in the middle: by Ctrl-C, by Ctrl-C twice, by kill -9.

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "proto/wire/mcap/reader.h"
#include "tests/support/child_process.h"
#include "tests/support/terminal.h"
#include "where.h"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using telepalp::support::kCtrlC;
using telepalp::support::Terminal;

std::string read_all(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class DemoInATerminal : public testing::Test {
 protected:
  fs::path out() const { return folder_.path() / "out"; }
  fs::path partial() const { return out() / "session.mcap.partial"; }

  std::unique_ptr<Terminal> start() const {
    return std::make_unique<Terminal>(
        std::vector<std::string>{"/usr/bin/env", "TELEPALP_BIN=" TELEPALP_BINARY_DIR "/bin",
                                 TELEPALP_SOURCE_DIR "/deploy/demo", "--http-port", "0", "--out", out().string()});
  }
  std::uint64_t messages_of_session() const {
    auto reader = telepalp::wire::McapReader::open(out() / "session.mcap");
    EXPECT_TRUE(reader.ok()) << to_string(reader.error());
    return reader ? reader->summary().statistics.message_count : 0;
  }

  telepalp::support::TemporaryFolder folder_;
};

/// Times of Ctrl-C: after the first touchable picture, and again.
struct Interrupt {
  std::string name;
  std::chrono::milliseconds after;
  std::vector<std::chrono::milliseconds> again_after;
  friend std::ostream& operator<<(std::ostream& out, const Interrupt& test) { return out << test.name; }
};

class EndedByCtrlC : public DemoInATerminal, public testing::WithParamInterface<Interrupt> {};

TEST_P(EndedByCtrlC, LeavesAWholeSessionAndItsReport) {
  const auto demo = start();
  ASSERT_TRUE(demo->await_text("touchable; the control loop", 30s)) << demo->shown();
  std::this_thread::sleep_for(GetParam().after);
  demo->type(kCtrlC);
  for (const auto pause : GetParam().again_after) {
    std::this_thread::sleep_for(pause);
    demo->type(kCtrlC);
  }
  EXPECT_EQ(demo->wait(60s), 0) << demo->shown();
  EXPECT_FALSE(fs::exists(partial())) << demo->shown();
  EXPECT_GT(messages_of_session(), 0U);
  for (const char* name : {"report.html", "report.json", "view.png"}) EXPECT_TRUE(fs::exists(out() / name)) << name;
}

INSTANTIATE_TEST_SUITE_P(Times, EndedByCtrlC,
                         testing::Values(Interrupt{"once", 1500ms, {}}, Interrupt{"at_once", 0ms, {}},
                                         Interrupt{"twice", 1000ms, {30ms}},
                                         Interrupt{"held_down", 700ms, {30ms, 30ms, 30ms, 30ms, 30ms, 30ms}}),
                         [](const auto& test) { return test.param.name; });

/// A program that has ended stays in /proc until its parent asks for its exit code, which the first process of a
/// container may never do. Then its command line is empty.
bool runs(const std::string& program) { return !read_all("/proc/" + program + "/cmdline").empty(); }

TEST_F(DemoInATerminal, EndedByKillLeavesNoProgramBehindAndTheSessionIsWhole) {
  const auto demo = start();
  ASSERT_TRUE(demo->await_text("touchable; the control loop", 30s)) << demo->shown();
  std::this_thread::sleep_for(1s);
  const std::string pid = std::to_string(demo->pid());
  std::istringstream children(read_all("/proc/" + pid + "/task/" + pid + "/children"));
  std::vector<std::string> programs;
  for (std::string child; children >> child;)
    if (read_all("/proc/" + child + "/comm").starts_with("telepalp-")) programs.push_back(child);
  ASSERT_EQ(programs.size(), 3U);
  ::kill(demo->pid(), SIGKILL);
  EXPECT_EQ(demo->wait(5s), 128 + SIGKILL);
  for (const std::string& program : programs) {
    for (int tries = 0; tries < 1000 && runs(program); ++tries) std::this_thread::sleep_for(10ms);
    EXPECT_FALSE(runs(program)) << read_all("/proc/" + program + "/cmdline");
  }
  EXPECT_FALSE(fs::exists(partial()));
  EXPECT_GT(messages_of_session(), 100U);
}

}  // namespace
