// telepalp-record expire: which recordings have expired, and that these, and no others, are deleted with a line in the
// log of deletions.

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "clients/record/retention/expire.h"
#include "clients/record/retention/retention_rules.h"
#include "proto/keys/audit_chain.h"
#include "tests/clients/recorder_stage.h"

namespace telepalp::record {
namespace {

namespace fs = std::filesystem;
using std::chrono::days;
using std::chrono::hours;

constexpr WallTime on(int year, unsigned month, unsigned day) {
  return std::chrono::sys_days(std::chrono::year(year) / month / day);
}

struct RetentionCase {
  const char* name;
  const char* consent;
  int keep_days;          ///< 0: no rule
  const char* withdrawn;  ///< a list
  WallTime began;
  bool is_judged;
  bool expired;
};

constexpr WallTime kNow = on(2027, 3, 1) + hours(12);
const RetentionCase kHardCases[] = {
    {"no rule", "signed form 4711", 0, "", on(2015, 2, 1), true, false},
    {"on the last day that the consent names", "until 2027-03-01", 0, "", on(2027, 1, 1), true, false},
    {"the day after it", "until 2027-02-28", 0, "", on(2027, 1, 1), true, true},
    {"a leap day that does not exist", "until 2027-02-29", 0, "", on(2027, 1, 1), false, false},
    {"a month that does not exist", "until 2027-13-01", 0, "", on(2027, 1, 1), false, false},
    {"a number that is no date", "until 20270301", 0, "", on(2027, 1, 1), true, false},
    {"older than the site keeps, though the consent goes on", "until 2030-01-01", 30, "", on(2027, 1, 1), true, true},
    {"a day younger", "", 60, "", on(2027, 1, 1), true, false},
    {"to the second as old as the site keeps", "", 30, "", kNow - days(30), true, true},
    {"withdrawn by its form", "signed form 4711, study 17", 0, "form 4711", on(2027, 1, 1), true, true},
    {"withdrawn is a form whose number begins alike", "signed form 4711", 0, "form 471", on(2027, 1, 1), true, false},
    {"withdrawn is a form whose number ends alike", "signed form 14711", 0, "4711", on(2027, 1, 1), true, false},
    {"a comment withdraws nothing", "signed form 4711", 0, "# form 4711\n\n  \n", on(2027, 1, 1), true, false},
    {"an umlaut is a letter", "Bergström", 0, "Bergstr", on(2027, 1, 1), true, false},
    {"withdrawn by the name of its file", "", 0, "x\r\n a.mcap # told by phone\r\n", on(2027, 1, 1), true, true},
    {"withdrawn, though its date cannot be right", "form 1", 9, "form 1", on(1970, 1, 1), true, true},
    {"a clock that was not set", "form 1", 9, "", on(1970, 1, 1), false, false},
    {"a date in the future", "", 9, "", kNow + days(2), false, false},
    {"no consent and a withdrawn list", "", 0, "form 1", on(2027, 1, 1), true, false},
};

TEST(Retention, EachHardCaseIsJudgedAsItsNameSays) {
  for (const RetentionCase& one : kHardCases) {
    RetentionRules rules{.keep = {}, .withdrawn = withdrawn_in(one.withdrawn)};
    if (one.keep_days > 0) rules.keep = days(one.keep_days);
    const Result<Judgement> judged = judge({"a.mcap", one.began, one.consent}, rules, kNow);
    ASSERT_EQ(judged.ok(), one.is_judged) << one.name;
    if (judged) {
      EXPECT_EQ(judged->expired, one.expired) << one.name << ": " << judged->reason;
      EXPECT_FALSE(judged->reason.empty()) << one.name;
    } else {
      EXPECT_FALSE(judged.error().fix.empty()) << one.name;
    }
  }
}

class Expire : public Recorder {
 protected:
  void SetUp() override {
    fs::create_directory(in("folder"));
    write("form1.mcap", "signed form 1");
    write("form2.mcap", "signed form 2, until 2020-01-01");
    write("young.mcap", "signed form 3");
    std::ofstream(in("folder/form1.mcap.notes.json")) << R"({"notes":[]})";
    std::ofstream(in("folder/other.txt")) << "not a session";
    std::ofstream(in("withdrawn")) << "form 1\nform 99\n";
  }
  void write(const std::string& name, const std::string& consent) const {
    wire::SessionInfo info = wire::samples::kInfo;
    info.consent = consent;
    auto writer = wire::McapWriter::open(in("folder") / name, info);
    ASSERT_TRUE(writer) << to_string(writer.error());
    for (const wire::Message& message : wire::samples::session(0.1, 5000)) ASSERT_TRUE(writer->write(message));
    ASSERT_TRUE(writer->close());
  }
  /// Runs `telepalp-record expire` on the folder; out() has what it printed.
  int expire(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"expire", in("folder"), "--withdrawn", in("withdrawn")});
    return run(more);
  }
  bool has(const std::string& name) const { return fs::exists(in("folder") / name); }
  std::string deletions() const { return bytes_of(in("folder/deletions.log")); }
};

TEST_F(Expire, ADryRunSaysWhatItWouldDeleteAndChangesNothing) {
  EXPECT_EQ(expire(), 0);
  EXPECT_NE(log().find("would delete: form1.mcap"), std::string::npos) << log();
  EXPECT_NE(log().find("would delete: form2.mcap"), std::string::npos) << log();
  EXPECT_NE(log().find("keep: young.mcap"), std::string::npos) << log();
  EXPECT_NE(log().find("no session here is named by: form 99"), std::string::npos) << log();
  EXPECT_NE(log().find("Nothing was deleted"), std::string::npos) << log();
  for (const char* name : {"form1.mcap", "form1.mcap.notes.json", "form2.mcap", "young.mcap"}) EXPECT_TRUE(has(name));
  EXPECT_FALSE(has("deletions.log"));
}

TEST_F(Expire, DeletesWhatTheDryRunNamedWithItsNotesAndLogsIt) {
  constexpr const char* kHalfWritten = ".form1.mcap.notes.json.0123abcd.unfinished";  // by a server that was killed
  constexpr const char* kOfAnother = ".young.mcap.notes.json.0123abcd.unfinished";
  for (const char* name : {kHalfWritten, kOfAnother}) std::ofstream(in("folder") / name) << R"({"notes":[]})";
  EXPECT_EQ(expire({"--delete"}), 0) << log();
  for (const char* name : {"form1.mcap", "form1.mcap.notes.json", kHalfWritten, "form2.mcap"})
    EXPECT_FALSE(has(name)) << name;
  for (const char* name : {"young.mcap", kOfAnother, "other.txt"}) EXPECT_TRUE(has(name)) << name;
  EXPECT_NE(deletions().find("event=delete by=\"account "), std::string::npos) << deletions();
  EXPECT_NE(deletions().find("event=deleted file=\"form1.mcap\""), std::string::npos) << deletions();
  EXPECT_NE(deletions().find("consent=\"signed form 1\" reason=\"its consent was withdrawn: form 1\""),
            std::string::npos)
      << deletions();
  keys::AuditVerifier verifier;
  EXPECT_TRUE(verifier.add_file(in("folder/deletions.log")));
  EXPECT_EQ(verifier.position().lines, 4u);
  EXPECT_NE(log().find(verifier.position().hash), std::string::npos) << "the anchor is printed";
  EXPECT_EQ(expire({"--delete"}), 0) << "a second run has nothing to do";
  write("again.mcap", "form 1");
  EXPECT_EQ(expire({"--delete"}), 0);
  keys::AuditVerifier later;
  EXPECT_TRUE(later.add_file(in("folder/deletions.log"))) << "the chain goes on";
  EXPECT_EQ(later.position().lines, 6u);
}

TEST_F(Expire, DeletesNothingWhenTheLogWasAlteredOrIsInUse) {
  EXPECT_EQ(expire({"--delete"}), 0);
  write("again.mcap", "form 1");
  const int held = ::open(in("folder/deletions.log").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(expire({"--delete"}), 1);
  EXPECT_TRUE(has("again.mcap"));
  ::close(held);
  std::string text = deletions();
  text[text.find("form2")] = 'F';
  std::ofstream(in("folder/deletions.log"), std::ios::trunc) << text;
  EXPECT_EQ(expire({"--delete"}), 1);
  EXPECT_TRUE(has("again.mcap")) << log();
  EXPECT_EQ(expire({"--delete", "--audit", in("folder") / "none" / "log"}), 1);
  EXPECT_TRUE(has("again.mcap")) << log();
}

TEST_F(Expire, KeepsWhatCannotBeJudgedAndSaysSo) {
  std::string bytes = bytes_of(in("folder/form2.mcap"));
  std::ofstream(in("folder/damaged.mcap"), std::ios::binary) << bytes.substr(0, bytes.size() - 40);
  std::ofstream(in("folder/empty.mcap"));
  fs::create_symlink(in("folder/form2.mcap"), in("folder/link.mcap"));
  EXPECT_EQ(expire({"--delete"}), 1);
  EXPECT_TRUE(has("damaged.mcap"));
  EXPECT_TRUE(has("empty.mcap"));
  EXPECT_TRUE(fs::is_symlink(in("folder/link.mcap")));
  EXPECT_FALSE(has("form2.mcap"));
  EXPECT_NE(log().find("not judged, so kept: damaged.mcap"), std::string::npos) << log();
  std::ofstream(in("withdrawn"), std::ios::app) << "damaged.mcap\n";
  EXPECT_EQ(expire({"--delete"}), 1) << "empty.mcap is still not judged";
  EXPECT_FALSE(has("damaged.mcap")) << "the name of a file is enough";
}

TEST_F(Expire, AnUnfinishedRecordingIsDeletedUnlessARecorderWritesIt) {
  const std::string whole = bytes_of(in("folder/form2.mcap"));
  std::ofstream(in("folder/left.mcap.partial"), std::ios::binary) << whole.substr(0, whole.size() * 3 / 4);
  const int recorder = ::open(in("folder/left.mcap.partial").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(recorder, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(expire({"--delete"}), 1);
  EXPECT_TRUE(has("left.mcap.partial")) << log();
  EXPECT_NE(log().find("still being recorded"), std::string::npos) << log();
  ::close(recorder);
  EXPECT_EQ(expire({"--delete"}), 0) << log();
  EXPECT_FALSE(has("left.mcap.partial"));
}

TEST_F(Expire, WhatTheDiskRefusesIsSaidAndLogged) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may delete everything";
  ::chmod(in("folder").c_str(), 0500);
  EXPECT_EQ(expire({"--delete", "--audit", in("log.of.deletions")}), 1);
  ::chmod(in("folder").c_str(), 0700);
  EXPECT_TRUE(has("form1.mcap"));
  EXPECT_NE(bytes_of(in("log.of.deletions")).find("event=not-deleted"), std::string::npos);
}

TEST_F(Expire, AWrongCommandLineDeletesNothing) {
  EXPECT_EQ(run({"expire"}), 2);
  EXPECT_EQ(run({"expire", in("folder"), in("folder")}), 2);
  EXPECT_EQ(run({"expire", in("folder"), "--keep-days", "0"}), 2);
  EXPECT_EQ(run({"expire", in("folder"), "--withdrawn", in("missing"), "--delete"}), 2);
  EXPECT_EQ(run({"expire", in("missing"), "--keep-days", "1", "--delete"}), 1);
  EXPECT_TRUE(has("form2.mcap"));
}

}  // namespace
}  // namespace telepalp::record
