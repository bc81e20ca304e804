// The audit log: what limits it, how it goes on from file to file, and what it does when it was damaged.

#include <gtest/gtest.h>

#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;
using access::AuditEvent;
using keys::Role;

void no_words(const std::string&) {}

/// Whether all files of the ring's log verify as one chain; else why not.
std::string flaw_of(const KeyRing& ring) {
  keys::AuditVerifier verifier;
  for (const fs::path& file : keys::audit_files(ring.folder.path() / "audit.log"))
    if (const Result<void> follows = verifier.add_file(file); !follows) return to_string(follows.error());
  return {};
}

TEST(AuditLog, APersonWhoJoinsWithoutEndFillsNoDiskAndEachStreamHasItsLine) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", no_words);
  ASSERT_TRUE(log.ok());
  std::uint64_t streams = 0;
  const auto hour = std::chrono::milliseconds(std::chrono::hours(1)).count();
  for (std::int64_t ms = 0; ms < hour; ms += 10) {
    const keys::WallTime now = ring.now + std::chrono::milliseconds(ms);
    if (!(*log)->may_join("07", now)) continue;
    ++streams;
    (*log)->note(AuditEvent::Joined, "07", "who=viewer vera program=\"telepalp-view\" from=10.0.0.7:47110", now);
    (*log)->note(AuditEvent::Left, "07", "who=viewer vera program=\"telepalp-view\" from=10.0.0.7:47110", now);
  }
  EXPECT_GE(streams, 100u) << "a bad connection may come back often";
  EXPECT_EQ((*log)->lines(), 2 * streams);
  EXPECT_LT(24 * ring.audit().size(), 20u << 20) << "bytes a day";
}

TEST(AuditLog, TheLineOfAWatchersStreamHasTheConsentThatTheWatcherStated) {
  KeyedSite site;
  KeyedClient asked(site, site.ring.key("vera", Role::Viewer), "viewer", {}, "127.0.0.1", 0, "signed form 12");
  KeyedClient silent(site, site.ring.key("walt", Role::Viewer));
  ASSERT_TRUE(site.run_until([&] { return asked.connected() && silent.connected(); }));
  const auto line_of = [&](const std::string& who) {
    const std::string text = site.ring.audit();
    const std::size_t at = text.find("event=joined who=" + who);
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_NE(line_of("viewer vera").find("consent=\"signed form 12\""), std::string::npos) << site.ring.audit();
  EXPECT_NE(line_of("viewer walt").find("consent=\"not stated\""), std::string::npos) << site.ring.audit();
}

TEST(AuditLog, APersonWhoIsRefusedWithoutEndFillsNoDisk) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", no_words);
  for (int ms = 0; ms < 3'600'000; ms += 10)
    (*log)->note(AuditEvent::Refused, "07", "who=viewer vera", ring.now + std::chrono::milliseconds(ms));
  EXPECT_LT((*log)->lines(), 1200u);
  EXPECT_NE(ring.audit().find("left-out="), std::string::npos);
}

TEST(AuditLog, WhoConnectsTooOftenIsToldToWaitAndAColleagueIsNot) {
  KeyedSite site;
  const auto vera = site.ring.key("vera", Role::Viewer);
  for (int line = 0; line < 200; ++line) site.access->note(AuditEvent::Refused, vera->identity, "why=\"test\"");
  KeyedClient again(site, vera);
  ASSERT_TRUE(site.run_until([&] { return again.link.not_served_because().has_value(); }));
  EXPECT_EQ(again.link.not_served_because()->what, "the key of viewer vera connects too often");
  KeyedClient colleague(site, site.ring.key("walt", Role::Viewer));
  EXPECT_TRUE(site.run_until([&] { return colleague.connected(); }));
}

TEST(AuditLog, AFullFileIsFollowedByOneThatContinuesItsChain) {
  const KeyRing ring;
  const fs::path file = ring.folder.path() / "audit.log";
  for (int run = 0; run < 4; ++run) {
    const auto log = access::AuditLog::open(file, no_words, 2000);
    ASSERT_TRUE(log.ok());
    for (int line = 0; line < 25; ++line) (*log)->note(AuditEvent::Joined, "07", "who=viewer vera", ring.now);
  }
  const std::vector<fs::path> files = keys::audit_files(file);
  ASSERT_GE(files.size(), 5u);
  EXPECT_EQ(files.back(), file);
  for (const fs::path& one : files) EXPECT_LT(fs::file_size(one), 2300u) << one;
  EXPECT_EQ(flaw_of(ring), "");
  fs::remove(files.front());
  EXPECT_EQ(flaw_of(ring), "") << "an archived file takes no other with it";
  fs::remove(files[2]);
  EXPECT_NE(flaw_of(ring).find("lines directly before it were removed"), std::string::npos) << flaw_of(ring);
}

TEST(AuditLog, AServerThatEndedBetweenTwoFilesContinuesTheChain) {
  for (const bool begun : {false, true}) {
    const KeyRing ring;
    const fs::path file = ring.folder.path() / "audit.log";
    (*access::AuditLog::open(file, no_words))->note(AuditEvent::Started, std::nullopt, "", ring.now);
    fs::rename(file, keys::next_audit_file(file));
    if (begun) std::ofstream(file) << std::flush;  // the next file was made, and its first line was not written
    (*access::AuditLog::open(file, no_words))->note(AuditEvent::Started, std::nullopt, "", ring.now);
    EXPECT_EQ(flaw_of(ring), "");
    EXPECT_NE(ring.audit().find("event=continues lines=1 after="), std::string::npos) << ring.audit();
  }
}

TEST(AuditLog, TwoServersCannotWriteOneLog) {
  const KeyRing ring;
  const fs::path file = ring.folder.path() / "audit.log";
  {
    const auto first = access::AuditLog::open(file, no_words, 2000);
    ASSERT_TRUE(first.ok());
    const auto second = access::AuditLog::open(file, no_words);
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().what, "another server writes this audit log");
    for (int line = 0; line < 25; ++line) (*first)->note(AuditEvent::Joined, "07", "who=viewer vera", ring.now);
    ASSERT_GE(keys::audit_files(file).size(), 2u);
    EXPECT_FALSE(access::AuditLog::open(file, no_words).ok()) << "the next file of the log is locked, too";
  }
  EXPECT_TRUE(access::AuditLog::open(file, no_words).ok()) << "the lock ends with its owner";
  EXPECT_EQ(flaw_of(ring), "");
}

TEST(AuditLog, APersonsNameCannotImitateALineThatContinuesAnotherFile) {
  keys::AuditPosition elsewhere{.lines = 7, .hash = std::string(64, 'a')};
  const std::string forged =
      keys::audit_line(elsewhere, "time=1 event=joined who=x event=continues lines=7 after=" + std::string(64, 'a'));
  keys::AuditVerifier verifier;
  EXPECT_FALSE(verifier.add(std::string_view(forged).substr(0, forged.size() - 1)).ok());
}

TEST(AuditLog, ItsTimeDoesNotRunBackwardsWhenTheClockIsSetBack) {
  const KeyRing ring;
  const fs::path file = ring.folder.path() / "audit.log";
  (*access::AuditLog::open(file, no_words))->note(AuditEvent::Started, std::nullopt, "", ring.now);
  const auto log = access::AuditLog::open(file, no_words);  // a new start, after the clock was set back
  (*log)->note(AuditEvent::Started, std::nullopt, "", ring.now - std::chrono::hours(2));
  (*log)->note(AuditEvent::Started, std::nullopt, "", ring.now + std::chrono::hours(2));
  std::istringstream lines(ring.audit());
  std::vector<std::string> times;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("time=");
    times.push_back(line.substr(at, line.find(' ', at) - at));
  }
  ASSERT_EQ(times.size(), 3u);
  EXPECT_EQ(times[0], times[1]);
  EXPECT_LT(times[1], times[2]);
  EXPECT_NE(ring.audit().find(" clock="), std::string::npos) << "the clock's own time is kept, too: " << ring.audit();
}

TEST(AuditLog, ADamagedOneIsAnAlarmAndNotANewBeginning) {
  const KeyRing ring;
  const fs::path file = ring.folder.path() / "audit.log";
  for (int run = 0; run < 3; ++run)
    (*access::AuditLog::open(file, no_words))->note(AuditEvent::Started, std::nullopt, "", ring.now);
  std::string text = ring.audit();
  text[text.size() / 2] ^= 1;  // in the second of three lines
  std::ofstream(file, std::ios::binary) << text;
  std::vector<std::string> said;
  const auto open = [&] {
    return access::AuditLog::open(file, [&](const std::string& words) { said.push_back(words); });
  };
  {
    const auto log = open();
    EXPECT_EQ((*log)->lines(), 1u) << "it goes on after the last unaltered line";
    EXPECT_NE((*log)->alarm().find("audit.log.damaged-1"), std::string::npos);
    (*log)->note(AuditEvent::Started, std::nullopt, "", ring.now);
  }
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("ALARM: " + file.string() + ", line 2: the hash of line 2 does not match"), std::string::npos)
      << said[0];
  EXPECT_NE(ring.audit().find("event=continues lines=1 after="), std::string::npos) << ring.audit();
  EXPECT_NE(ring.audit().find("damaged=audit.log.damaged-1"), std::string::npos) << ring.audit();
  EXPECT_FALSE((*open())->alarm().empty()) << "a restart does not end the alarm";
  fs::rename(file.string() + ".damaged-1", ring.folder.path() / "archive");
  EXPECT_EQ((*open())->alarm(), "");
}

TEST(AuditAnchors, ALogThatWasCutOrRemovedIsAnAlarmAtTheNextStart) {
  for (const bool removed : {false, true}) {
    const KeyRing ring;
    std::vector<std::string> said;
    const access::Access::Options options{
        .key = ring.server_key(ring.now), .revoked = {}, .audit = {}, .say = [&](const std::string& text) {
          said.push_back(text);
        }};
    {
      const auto access = *access::Access::with_key(options);
      access->note_own(AuditEvent::Started, "");
      EXPECT_NE(access->anchor().find("anchor time="), std::string::npos);
      EXPECT_EQ(access->anchor().find("lines=1 hash="), access->anchor().find("lines="));
      access->note_own(AuditEvent::Stopped, "");
      EXPECT_EQ(access->alarm(), "");
    }
    EXPECT_EQ(std::count_if(said.begin(), said.end(),
                            [](const std::string& text) { return text.starts_with("audit log: anchor"); }),
              2);
    EXPECT_EQ((*access::Access::with_key(options))->alarm(), "") << "an untouched log is no alarm";
    const std::string whole = ring.audit();
    std::ofstream(ring.folder.path() / "audit.log", std::ios::binary) << whole.substr(0, whole.find('\n') + 1);
    if (removed) fs::remove(ring.folder.path() / "audit.log");
    const auto access = *access::Access::with_key(options);
    EXPECT_NE(access->alarm().find("was removed, cut or computed anew"), std::string::npos) << access->alarm();
    EXPECT_NE(ring.audit().find("event=damaged"), std::string::npos) << ring.audit();
  }
}

TEST(TokenBackOff, OneWrongTokenKeepsNobodyElseOutOfTheSameAddress) {
  const auto start = std::chrono::steady_clock::now();
  access::TokenBackOff back_off;
  int tried = 0;
  for (int ms = 0; ms < 600'000; ms += 10) {
    const auto now = start + std::chrono::milliseconds(ms);
    if (back_off.may_try("10.0.0.9", "expired", now)) {
      ++tried;
      back_off.failed("10.0.0.9", "expired", now);
    }
    EXPECT_TRUE(back_off.may_try("10.0.0.9", "a colleague's", now)) << ms;
  }
  EXPECT_LE(tried, 25) << "in ten minutes";
}

TEST(TokenBackOff, GuessingIsSlowedDownAndWhoWasRightThereBeforeStillGetsIn) {
  const auto start = std::chrono::steady_clock::now();
  access::TokenBackOff back_off;
  back_off.succeeded("10.0.0.9", "a colleague's", start);
  int checked = 0;
  for (int guess = 0; guess < 10'000; ++guess) {
    const auto now = start + std::chrono::milliseconds(guess);  // a thousand a second
    const std::string token = "guess " + std::to_string(guess);
    if (!back_off.may_try("10.0.0.9", token, now)) continue;
    ++checked;
    back_off.failed("10.0.0.9", token, now);
  }
  EXPECT_LE(checked, 320) << "in ten seconds";
  EXPECT_TRUE(back_off.may_try("10.0.0.9", "a colleague's", start + 10s));
  EXPECT_TRUE(back_off.may_try("10.0.0.8", "another's", start + 10s)) << "other addresses are not held up";
  for (int i = 0; i < 5000; ++i) back_off.failed("address " + std::to_string(i), "x", start);
  EXPECT_LE(back_off.entries(), 2048u) << "memory is bounded";
}

TEST(KeyedLink, ManyStrangersThatGoAreOneLineOfTheLog) {
  KeyedSite site;
  for (int stranger = 0; stranger < 60; ++stranger) {
    boost::asio::ip::tcp::socket socket(site.io);
    socket.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
    boost::asio::write(socket, boost::asio::buffer("\x16\x03\x01garbage", 10));
    socket.close();
    site.io.poll();
  }
  site.run_until([&] { return site.listener->peers() == 0; });
  const auto lines = std::count_if(site.notes.begin(), site.notes.end(), [](const std::string& note) {
    return note.find("disconnected") != std::string::npos;
  });
  EXPECT_GE(lines, 1);
  EXPECT_LE(lines, 3) << "60 strangers came and went";
}

}  // namespace
}  // namespace telepalp::server
