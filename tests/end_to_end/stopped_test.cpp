// Every program in a real terminal, stopped by Ctrl-C: it says in one sentence what it kept, and its exit code is
// right.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/child_process.h"
#include "tests/support/terminal.h"
#include "where.h"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using telepalp::support::kCtrlC;
using telepalp::support::Terminal;

constexpr int kBySignal = 128 + SIGINT;

/// In `words`, FOLDER is a folder of the test's own, PIPE a pipe there that nobody writes to, and DATA telepalp's data.
struct Stopped {
  const char* name;
  std::vector<std::string> words;  ///< the first one: the program
  const char* after;               ///< text that is shown before Ctrl-C is typed; empty: half a second passes
  const char* says;
  int code;
  friend std::ostream& operator<<(std::ostream& out, const Stopped& row) { return out << row.name; }
};

const Stopped kRows[] = {
    {"server",
     {"telepalp-server", "--source", "synthetic", "--port", "0", "--http-port", "0"},
     "listening on",
     "stopping: Ctrl-C or another program stopped the server",
     0},
    {"station",
     {"telepalp-station", "--connect", "127.0.0.1:9", "--control", "none"},
     "waiting for the server",
     "ending: a signal stopped the station",
     0},
    {"trials",
     {"telepalp-station", "trials", "--out", "FOLDER/trials"},
     "",
     "telepalp-station: stopped: no file was written",
     kBySignal},
    {"record",
     {"telepalp-record", "--connect", "127.0.0.1:9", "--out", "FOLDER/s.mcap"},
     "",
     "ending without a file: Ctrl-C or another program stopped the recorder",
     0},
    {"verify",
     {"telepalp-record", "verify", "PIPE"},
     "",
     "telepalp-record: stopped: the sessions that it read are unchanged",
     kBySignal},
    {"view",
     {"telepalp-view", "--connect", "127.0.0.1:9", "--stats"},
     "",
     "stopped by Ctrl-C or by another program",
     1},
    {"link",
     {"telepalp-link", "--listen", "127.0.0.1:0", "--connect", "127.0.0.1:9", "--quiet"},
     "listens at",
     "stopping: Ctrl-C or another program stopped it",
     0},
    {"report",
     {"telepalp-report", "PIPE", "--out", "FOLDER/r"},
     "",
     "telepalp-report: stopped: the report in ",
     kBySignal},
    {"export",
     {"telepalp-export", "PIPE", "--csv", "/station/state", "--out", "FOLDER/s.csv"},
     "",
     "telepalp-export: stopped: no file was written",
     kBySignal},
    {"codec",
     {"telepalp-codec", "info", "PIPE"},
     "",
     "telepalp-codec: stopped: it has no result, and wrote no file",
     kBySignal},
    {"probe",
     {"telepalp-probe", "path", "--cloud", "DATA/torso/visible_human_torso.ply", "--out", "FOLDER/path.csv"},
     "spreading",
     "path.csv is not written",
     kBySignal},
    {"bench",
     {"telepalp-bench", "control"},
     "",
     "telepalp-bench: stopped: the figures of control come at its end",
     kBySignal},
};

class StoppedByCtrlC : public testing::TestWithParam<Stopped> {
 protected:
  /// `word` with the names of this test's files.
  [[nodiscard]] std::string filled(std::string word) const {
    for (const auto& [from, to] :
         {std::pair{std::string("FOLDER"), folder_.path().string()},
          std::pair{std::string("PIPE"), (folder_.path() / "pipe.mcap").string()},
          std::pair{std::string("DATA"), std::string(TELEPALP_SOURCE_DIR "/deploy/demo_data")}})
      if (const std::size_t at = word.find(from); at != std::string::npos) word.replace(at, from.size(), to);
    return word;
  }
  telepalp::support::TemporaryFolder folder_;
};

TEST_P(StoppedByCtrlC, SaysWhatItKept) {
  const Stopped& row = GetParam();
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe.mcap").c_str(), 0600), 0);
  std::vector<std::string> command;
  for (const std::string& word : row.words) command.push_back(filled(word));
  command.front() = TELEPALP_BINARY_DIR "/bin/" + command.front();
  Terminal program(command);
  if (*row.after != '\0')
    ASSERT_TRUE(program.await_text(row.after, 30s)) << program.shown();
  else
    std::this_thread::sleep_for(1s);
  program.type(kCtrlC);
  EXPECT_EQ(program.wait(20s), row.code) << program.shown();
  EXPECT_TRUE(program.await_text(row.says, 1s)) << program.shown();
}

INSTANTIATE_TEST_SUITE_P(Programs, StoppedByCtrlC, testing::ValuesIn(kRows),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(DemoStoppedByCtrlC, WithoutAFolderSaysThatNothingWasRecorded) {
  Terminal demo({"/usr/bin/env", "TELEPALP_BIN=" TELEPALP_BINARY_DIR "/bin", TELEPALP_SOURCE_DIR "/deploy/demo",
                 "--http-port", "0"});
  ASSERT_TRUE(demo.await_text("touchable; the control loop", 60s)) << demo.shown();
  demo.type(kCtrlC);
  EXPECT_EQ(demo.wait(30s), 0) << demo.shown();
  EXPECT_TRUE(demo.await_text("telepalp: ended; nothing was recorded (--out DIR records the run)", 1s)) << demo.shown();
}

}  // namespace
