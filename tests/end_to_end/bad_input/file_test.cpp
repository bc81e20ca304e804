// Files that are not whole, beside a doctor's session: a full disk, a recorder that is killed, and a session file with
// wrong offsets.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "tests/end_to_end/bad_input/insider.h"
#include "tests/end_to_end/bad_input/running_session.h"
#include "where.h"

namespace telepalp::bad_input {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const fs::path kPrograms = TELEPALP_BINARY_DIR "/bin";

class FileTest : public ::testing::Test {
 public:
  static RunningSession& session() { return SharedByTests<RunningSession>::get(); }

 protected:
  /// The programs inherit the ignored SIGXFSZ, so that a limit on a file's size fails a write instead of ending them.
  static void SetUpTestSuite() { std::signal(SIGXFSZ, SIG_IGN); }
  static fs::path key() {
    static const fs::path file = session().ring().write(
        "recorder.key",
        session().ring().authority.client_key(
            {.name = "quirin", .role = keys::Role::Qa, .now = session().ring().now, .valid = std::chrono::days(1)}));
    return file;
  }
  /// Records the session to `file` until `enough`, and then sends `signal`. Returns the recorder's exit code.
  static int record(const fs::path& file, int signal, const std::function<bool()>& enough) {
    support::ChildProcess recorder(kPrograms / "telepalp-record",
                                   {"--connect", "127.0.0.1:" + std::to_string(session().port()), "--key",
                                    key().string(), "--consent", "signed-form", "--out", file.string()},
                                   session().file("record.log"));
    for (int tenth = 0; tenth < 200 && !enough(); ++tenth) std::this_thread::sleep_for(100ms);
    recorder.signal(signal);
    return recorder.wait(20s).value_or(-1);
  }
  struct Ran {
    int exit_code = -1;
    std::string said;
    double most_MiB = 0.0;
  };
  static Ran run(const char* program, const std::vector<std::string>& arguments) {
    Ran ran;
    const fs::path log = session().file("run.log");
    support::ChildProcess child(kPrograms / program, arguments, log);
    std::optional<int> ended;
    for (int i = 0; i < 1200 && !ended; ++i) {
      ended = child.wait(25ms);
      ran.most_MiB = std::max(ran.most_MiB, most_resident_MiB(child.pid()));
    }
    ran.exit_code = ended.value_or(-1);
    ran.said = text_of(log);
    return ran;
  }
};

std::uintmax_t bytes_in(const fs::path& file) {
  std::error_code none;
  const std::uintmax_t bytes = fs::file_size(file, none);
  return none ? 0 : bytes;
}

/// No file of `process` may grow beyond `bytes` while this lives: its writes fail as on a full disk.
struct FullDiskOf {
  pid_t process;
  rlimit before{};
  FullDiskOf(pid_t of, std::uintmax_t bytes) : process(of) {
    EXPECT_EQ(::prlimit(process, RLIMIT_FSIZE, nullptr, &before), 0);
    rlimit full = before;
    full.rlim_cur = static_cast<rlim_t>(bytes);
    EXPECT_EQ(::prlimit(process, RLIMIT_FSIZE, &full, nullptr), 0);
  }
  ~FullDiskOf() { EXPECT_EQ(::prlimit(process, RLIMIT_FSIZE, &before, nullptr), 0); }
};

/// A viewer joins and leaves: at least two lines of the audit log.
void visit() {
  Insider visitor(FileTest::session().port(), FileTest::session().ring().key("vera", keys::Role::Viewer));
  visitor.say(greeting("vera"));
}

class BadInput30 : public FileTest {};
TEST_F(BadInput30, WhenTheDiskIsFullServerAndRecorderRaiseAnAlarmAndTheDoctorsSessionGoesOn) {
  const fs::path audit = session().file("audit.log");
  const fs::path log = session().file("server.log");
  for (int i = 0; i < 200 && bytes_in(audit) < bytes_in(log) + 4'000; ++i) visit();  // the limit leaves room in the log
  session().expect_undisturbed_by([&] {
    const FullDiskOf full(session().server().pid(), bytes_in(audit));
    visit();
    EXPECT_TRUE(comes(log, "ALARM: the audit log")) << text_of(log);
    // Each file of the recorder can grow to 1 MB, as on a disk that is nearly full.
    support::ChildProcess recorder(
        "/bin/bash",
        {"-c", "ulimit -f 1000; exec " + (kPrograms / "telepalp-record").string() +
                   " --connect 127.0.0.1:" + std::to_string(session().port()) + " --consent signed-form --key " +
                   key().string() + " --out " + session().file("full.mcap").string()},
        session().file("record.log"));
    EXPECT_TRUE(comes(session().file("record.log"), "the recording goes on in", 20s));
    recorder.signal(SIGINT);
    EXPECT_EQ(recorder.wait(20s), 1) << "messages were lost";
  });
  EXPECT_NE(text_of(session().file("record.log")).find("ALARM: "), std::string::npos);
  visit();
  EXPECT_TRUE(comes(audit, " not-written=")) << "there is room again: " << text_of(audit);
  const Ran verified = run("telepalp-keys", {"audit-verify", audit.string()});
  EXPECT_EQ(verified.exit_code, 0) << verified.said;
}

class BadInput31 : public FileTest {};
TEST_F(BadInput31, ARecorderThatIsKilledLeavesAFileThatTheRepairCompletes) {
  const fs::path file = session().file("killed.mcap");
  const fs::path partial = file.string() + ".partial";
  session().expect_undisturbed_by(
      [&] { EXPECT_EQ(record(file, SIGKILL, [&] { return bytes_in(partial) > 3'000'000; }), 128 + SIGKILL); });
  const Ran repaired = run("telepalp-record", {"repair", partial.string()});
  EXPECT_EQ(repaired.exit_code, 0) << repaired.said;
  EXPECT_NE(repaired.said.find("was not completed by its recorder"), std::string::npos) << repaired.said;
  EXPECT_LT(repaired.most_MiB, 300.0);
  const Ran verified = run("telepalp-record", {"verify", file.string()});
  EXPECT_EQ(verified.exit_code, 0) << verified.said;
}

/// Little-endian number of 8 bytes at `at`.
std::uint64_t number_at(const std::string& bytes, std::size_t at) {
  std::uint64_t number = 0;
  for (std::size_t i = 8; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Makes each chunk index of a session file name `offset` as its chunk's begin. Returns the number of changed indexes.
/// The layout is MCAP's: the footer is the last record, and opcode 0x08 is a chunk index.
int lie_about_chunks(const fs::path& file, std::uint64_t offset) {
  constexpr std::size_t kMagic = 8, kHeader = 9, kFooter = kHeader + 20;
  std::string bytes = text_of(file);
  const std::size_t footer = bytes.size() - kMagic - kFooter;
  for (std::size_t i = 0; i < 4; ++i) bytes[footer + kHeader + 16 + i] = 0;  // 0: the summary has no CRC
  int changed = 0;
  for (std::size_t at = number_at(bytes, footer + kHeader); at < footer; at += kHeader + number_at(bytes, at + 1)) {
    if (bytes[at] != 0x08) continue;
    for (std::size_t i = 0; i < 8; ++i) bytes[at + kHeader + 16 + i] = static_cast<char>(offset >> (8 * i));
    ++changed;
  }
  std::ofstream(file, std::ios::binary) << bytes;
  return changed;
}

class BadInput32 : public FileTest {};
TEST_F(BadInput32, ASessionFileWithWrongOffsetsIsRefusedByEachProgramAndRepaired) {
  const fs::path file = session().file("lying.mcap");
  ASSERT_EQ(record(file, SIGINT, [&] { return bytes_in(file.string() + ".partial") > 3'000'000; }), 0)
      << text_of(session().file("record.log"));
  ASSERT_GT(lie_about_chunks(file, std::uint64_t{1} << 60), 0);
  session().expect_undisturbed_by([&] {
    const Ran served = run("telepalp-server", {"--source", "session:" + file.string(), "--port", "0"});
    EXPECT_EQ(served.exit_code, 1) << served.said;
    EXPECT_NE(served.said.find("lying.mcap"), std::string::npos) << served.said;
    EXPECT_NE(served.said.find("fix: "), std::string::npos) << served.said;
    EXPECT_LT(served.most_MiB, 200.0);
    const std::string unmade = session().file("unmade").string();
    for (const auto& [program, arguments] : std::vector<std::pair<const char*, std::vector<std::string>>>{
             {"telepalp-record", {"info", file.string()}},
             {"telepalp-record", {"cut", file.string(), "--to", "1s", "--out", unmade}},
             {"telepalp-export", {file.string(), "--csv", "/station/state", "--out", unmade}},
             {"telepalp-replay", {file.string(), "--out", unmade}}}) {
      const Ran refused = run(program, arguments);
      // telepalp-replay ends with 2: its exit code 1 says that an assertion does not hold.
      EXPECT_EQ(refused.exit_code, program == std::string_view("telepalp-replay") ? 2 : 1) << program << refused.said;
      EXPECT_NE(refused.said.find("fix: telepalp-record repair"), std::string::npos) << program << ": " << refused.said;
      EXPECT_LT(refused.most_MiB, 200.0) << program;
      EXPECT_FALSE(fs::exists(unmade)) << program;
    }
    const Ran reported = run("telepalp-report", {file.string(), "--out", session().file("report").string()});
    EXPECT_LT(reported.exit_code, 2) << reported.said;
    EXPECT_LT(reported.most_MiB, 300.0);
  });
  EXPECT_EQ(run("telepalp-record", {"verify", file.string()}).exit_code, 1);
  const fs::path whole = session().file("whole.mcap");
  const Ran repaired = run("telepalp-record", {"repair", file.string(), "--out", whole.string()});
  EXPECT_EQ(repaired.exit_code, 0) << repaired.said;
  EXPECT_EQ(run("telepalp-record", {"verify", whole.string()}).exit_code, 0);
}

}  // namespace
}  // namespace telepalp::bad_input
