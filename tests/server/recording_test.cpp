#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "server/recording/session_recorder.h"
#include "tests/support/child_process.h"

namespace telepalp::recording {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::system_clock::time_point kNoon{std::chrono::seconds{1'795'348'800}};  // 2026-11-22 12:00 UTC

msg::RecordingCommand begin(const std::string& consent = "study 17, signed") {
  msg::RecordingCommand command;
  command.set_record(true);
  command.set_consent(consent);
  return command;
}

msg::RecordingCommand end() {
  msg::RecordingCommand command;
  command.set_record(false);
  return command;
}

/// A recorder whose program is a shell script instead of telepalp-record. The script gets the same arguments.
struct Recorder {
  support::TemporaryFolder folder;
  std::unique_ptr<SessionRecorder> recorder;

  explicit Recorder(const std::string& script) {
    const std::filesystem::path program = folder.path() / "recorder";
    std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    recorder =
        SessionRecorder::open({.folder = folder.path(), .program = program, .key = {}, .server = "127.0.0.1:7400"})
            .value();
  }
  /// The state once the program has ended.
  msg::RecordingState over() const {
    msg::RecordingState state = recorder->state();
    for (int look = 0; look < 3000 && state.phase() != msg::RecordingState::PHASE_IDLE; ++look) {
      std::this_thread::sleep_for(10ms);
      state = recorder->state();
    }
    return state;
  }
};

// $4 is the file of: --connect HOST:PORT --out FILE --consent TEXT.
constexpr const char* kUntilAsked =
    "trap 'mv \"$4.partial\" \"$4\"; exit 0' TERM\necho \"$2 $6\" > \"$4.partial\"\nwhile :; do sleep 0.02; done";

TEST(RecordingCommand, NobodyIsRecordedWithoutConsent) {
  EXPECT_TRUE(read_command(R"({"record":true,"consent":"study 17, signed"})").ok());
  EXPECT_TRUE(read_command(R"({"record":false})").ok());
  for (const char* json :
       {R"({"record":true})", R"({"record":true,"consent":"   "})", R"({"consent":"signed"})",
        R"({"record":true,"consent":"two\nlines"})", R"({"record":true,"file":"/etc/passwd"})", "{", ""})
    EXPECT_FALSE(read_command(json).ok()) << json;
  EXPECT_FALSE(read_command(R"({"record":true,"consent":")" + std::string(501, 'x') + "\"}").ok());
  std::string longest;  // the page's longest consent, in letters of four bytes
  for (int letter = 0; letter < 120; ++letter) longest += "\U00010400";
  EXPECT_TRUE(read_command(R"({"record":true,"consent":")" + longest + "\"}").ok());
}

TEST(SessionRecorder, ARecordingIsNamedAfterItsBeginningAndCompletedWhenItIsEnded) {
  Recorder it(kUntilAsked);
  ASSERT_TRUE(it.recorder->apply(begin(), kNoon).ok());
  EXPECT_EQ(it.recorder->state().phase(), msg::RecordingState::PHASE_RECORDING);
  EXPECT_EQ(it.recorder->state().file(), "session_20261122_120000.mcap");
  for (int look = 0; look < 3000 && it.recorder->state().bytes() == 0; ++look) std::this_thread::sleep_for(10ms);
  ASSERT_TRUE(it.recorder->apply(end(), kNoon).ok());
  const msg::RecordingState over = it.over();
  EXPECT_EQ(over.phase(), msg::RecordingState::PHASE_IDLE);
  EXPECT_EQ(over.problem(), "");
  std::ifstream file(it.folder.path() / over.file());
  std::string words;
  std::getline(file, words);
  EXPECT_EQ(words, "127.0.0.1:7400 study 17, signed");
  EXPECT_FALSE(std::filesystem::exists(it.folder.path() / (over.file() + ".log")))
      << "a log is kept after a failure alone";
}

TEST(SessionRecorder, OneRecordingAtATime) {
  Recorder it(kUntilAsked);
  EXPECT_FALSE(it.recorder->apply(end(), kNoon).ok()) << "nothing to end";
  ASSERT_TRUE(it.recorder->apply(begin(), kNoon).ok());
  EXPECT_FALSE(it.recorder->apply(begin(), kNoon + 1s).ok());
  EXPECT_EQ(it.recorder->state().file(), "session_20261122_120000.mcap");
}

TEST(SessionRecorder, AFailureIsToldInTheRecordersOwnWords) {
  Recorder it("echo 'error: the disk is full. fix: make room' >&2; exit 1");
  ASSERT_TRUE(it.recorder->apply(begin(), kNoon).ok());
  const msg::RecordingState over = it.over();
  EXPECT_EQ(over.problem(), "telepalp-record ended with exit code 1: error: the disk is full. fix: make room");
  ASSERT_TRUE(it.recorder->apply(begin(), kNoon + 1s).ok()) << "and a new attempt may begin";
  EXPECT_EQ(it.recorder->state().file(), "session_20261122_120001.mcap");
}

TEST(SessionRecorder, AMissingProgramOrFolderIsSaid) {
  const support::TemporaryFolder folder;
  auto recorder = SessionRecorder::open(
      {.folder = folder.path(), .program = folder.path() / "none", .key = {}, .server = "127.0.0.1:7400"});
  ASSERT_TRUE(recorder.ok());
  EXPECT_FALSE((*recorder)->apply(begin(), kNoon).ok());
  EXPECT_NE((*recorder)->state().problem(), "");
  EXPECT_FALSE(SessionRecorder::open({.folder = folder.path() / "none", .program = {}, .key = {}, .server = {}}).ok());
}

}  // namespace
}  // namespace telepalp::recording
