// telepalp-keys as its user runs it.

#include <gtest/gtest.h>

#include <fstream>

#include "proto/keys/audit_anchor.h"
#include "proto/keys/audit_chain.h"
#include "proto/keys/key_file.h"
#include "proto/keys/revocations.h"
#include "tests/proto/keys_program.h"

namespace telepalp::keys {
namespace {

TEST_F(KeysProgram, MakesAnAuthorityKeysAndTokensThatTheirOwnerAloneMayRead) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 0);
  ASSERT_EQ(run({"server", "--host", "10.0.0.5"}), 0);
  ASSERT_EQ(run({"client", "--name", "anna", "--role", "doctor"}), 0);
  ASSERT_EQ(run({"token", "--name", "vera", "--role", "viewer"}), 0);
  for (const char* secret : {"authority.key", "server.key", "anna.key", "vera.token"})
    EXPECT_EQ(mode_of(secret), 0600U) << secret;
  EXPECT_EQ(mode_of(""), 0700U);
  EXPECT_NE(text_of(folder / "anna.key").find("It allows: watch, touch, hand over, record"), std::string::npos);
}

TEST_F(KeysProgram, OutputThatAFullDiskDoesNotTakeIsAFailure) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 0);
  const std::string keys = TELEPALP_BINARY_DIR "/bin/telepalp-keys";
  support::ChildProcess process(
      "/bin/sh", {"-c", keys + " client --name anna --role doctor --dir " + folder.string() + " >/dev/full"}, log);
  EXPECT_EQ(process.wait(std::chrono::seconds(20)).value_or(-1), 1);
  EXPECT_NE(text_of(log).find("standard output"), std::string::npos) << text_of(log);
}

TEST_F(KeysProgram, InTheWrongOrderOrTwiceSaysWhatToDo) {
  EXPECT_EQ(run({"server", "--host", "10.0.0.5"}), 1);
  EXPECT_NE(text_of(log).find("telepalp-keys authority --dir"), std::string::npos) << text_of(log);
  ASSERT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 0);
  EXPECT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 1) << "a second authority would make all keys useless";
  EXPECT_EQ(run({"server"}), 2);
  EXPECT_NE(text_of(log).find("--host"), std::string::npos);
  EXPECT_EQ(run({"client", "--name", "anna"}), 2);
  EXPECT_EQ(run({"client", "--name", "anna", "--role", "boss"}), 2);
  ASSERT_EQ(run({"client", "--name", "anna", "--role", "qa"}), 0);
  const std::string first = text_of(folder / "anna.key");
  EXPECT_EQ(run({"client", "--name", "anna", "--role", "doctor"}), 1);
  EXPECT_EQ(text_of(folder / "anna.key"), first);
  EXPECT_EQ(run({"authority"}), 2) << "an authority without limits could sign for a bank";
  EXPECT_EQ(run({"dance"}), 2);
  EXPECT_EQ(run({"show"}), 2);
}

TEST_F(KeysProgram, RenewsAndRevokes) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 0);
  ASSERT_EQ(run({"client", "--name", "anna", "--role", "doctor"}), 0);
  const fs::path anna = folder / "anna.key";
  const std::string first = text_of(anna);
  ASSERT_EQ(run({"renew", anna.string()}), 0);
  EXPECT_NE(text_of(anna), first);
  const std::string list = text_of(folder / "revoked.crl");
  ASSERT_EQ(run({"revoke", anna.string()}), 0);
  EXPECT_GT(text_of(folder / "revoked.crl").size(), list.size());
  const std::string authority = text_of(folder / "authority.crt");
  EXPECT_EQ(Revocations::read(text_of(folder / "revoked.crl"), authority, "revoked.crl")->number(),
            Revocations::read(list, authority, "revoked.crl")->number() + 1);
  ASSERT_EQ(run({"revoke", anna.string()}), 0) << "twice is as good as once";
  EXPECT_EQ(run({"revoke", "no-such-file"}), 1);
}

TEST_F(KeysProgram, AuditVerifyFindsAnAlteredByteAndACutLine) {
  const fs::path audit = temporary.path() / "audit.log";
  AuditPosition position;
  std::string lines;
  for (int i = 0; i < 20; ++i) lines += audit_line(position, "event=joined name=anna");
  const auto write = [&](const std::string& text) { std::ofstream(audit, std::ios::binary) << text; };
  write(lines);
  EXPECT_EQ(run({"audit-verify", audit.string()}), 0) << text_of(log);
  std::string altered = lines;
  altered[lines.size() / 2] ^= 1;
  write(altered);
  EXPECT_EQ(run({"audit-verify", audit.string()}), 1);
  EXPECT_NE(text_of(log).find("was altered"), std::string::npos) << text_of(log);
  write(lines.substr(0, lines.size() - 5));
  EXPECT_EQ(run({"audit-verify", audit.string()}), 1);
  EXPECT_NE(text_of(log).find("cut off: the server was ended while it wrote"), std::string::npos) << text_of(log);
  EXPECT_NE(text_of(log).find("fix: compare the log with an earlier copy"), std::string::npos) << text_of(log);
}

TEST_F(KeysProgram, AuditVerifyReadsAcrossTheFilesOfALog) {
  const fs::path audit = temporary.path() / "audit.log";
  AuditPosition position;
  std::string first = audit_line(position, "time=1 event=joined name=anna");
  const std::string continues = "time=2 event=continues " + audit_continuation(position);
  std::string second = audit_line(position, continues);
  second += audit_line(position, "time=3 event=left name=anna");
  const auto write = [](const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  };
  write(audit.string() + ".1", first);
  write(audit, second);
  EXPECT_EQ(run({"audit-verify", audit.string()}), 0);
  EXPECT_NE(text_of(log).find("audit.log and 1 older file: 3 lines, none altered"), std::string::npos) << text_of(log);
  first[70] ^= 1;
  write(audit.string() + ".1", first);
  EXPECT_EQ(run({"audit-verify", audit.string()}), 1);
  EXPECT_NE(text_of(log).find("audit.log.1, line 1"), std::string::npos) << text_of(log);
  fs::remove(audit.string() + ".1");
  EXPECT_EQ(run({"audit-verify", audit.string()}), 0);
  EXPECT_NE(text_of(log).find("audit.log: 2 lines, none altered\nbefore them: 1 line in older files"),
            std::string::npos)
      << text_of(log);
}

TEST_F(KeysProgram, AuditVerifyFindsLinesThatWereRemovedAfterAnAnchorAndALogThatWasComputedAnew) {
  ASSERT_EQ(run({"authority", "--host", "10.0.0.0/8"}), 0);
  ASSERT_EQ(run({"server", "--host", "127.0.0.1"}), 0);
  const KeyFile server = *load_key(folder / "server.key", std::chrono::system_clock::now());
  const fs::path audit = temporary.path() / "audit.log", anchors = temporary.path() / "anchors";
  const auto write = [](const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
  };
  const auto log_of = [](int lines, const std::string& who) {
    AuditPosition position;
    std::string text;
    for (int line = 0; line < lines; ++line) text += audit_line(position, "time=1 event=joined name=" + who);
    return std::pair{text, position};
  };
  const auto [whole, end] = log_of(20, "anna");
  write(anchors,
        server.certificate + "telepalp-server: audit log: " + *anchor_line({.time = "1", .end = end}, server) + "\n");
  const auto verify = [&] { return run({"audit-verify", audit.string(), "--anchors", anchors.string()}); };
  write(audit, whole);
  EXPECT_EQ(verify(), 0) << text_of(log);
  EXPECT_NE(text_of(log).find("1 anchor of the server match"), std::string::npos) << text_of(log);
  write(audit, log_of(19, "anna").first);
  EXPECT_EQ(verify(), 1);
  EXPECT_NE(text_of(log).find("the log is shorter: at 1 it had 20 lines"), std::string::npos) << text_of(log);
  write(audit, log_of(25, "nobody").first);
  EXPECT_EQ(verify(), 1);
  EXPECT_NE(text_of(log).find("the log has another line"), std::string::npos) << text_of(log);
  std::string forged = text_of(anchors);
  forged[forged.find("lines=20") + 7] = '1';
  write(anchors, forged);
  EXPECT_EQ(verify(), 1);
  EXPECT_NE(text_of(log).find("the server's key did not sign it"), std::string::npos) << text_of(log);
}

}  // namespace
}  // namespace telepalp::keys
