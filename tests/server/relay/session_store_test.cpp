// Session files in a real NATS server with JetStream.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <thread>

#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/private_key.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "support/nats/streams.h"
#include "support/session_store/session_place.h"
#include "support/session_store/stored_blocks.h"
#include "tests/support/child_process.h"

namespace {

using namespace telepalp;
using namespace std::chrono_literals;
using session_store::StoredBlocks;
using wire::mcap::OutputFile;
using wire::mcap::Protection;

constexpr const char* kServer = "/usr/sbin/nats-server";  // of Debian's package

std::string noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

class SessionStore : public ::testing::Test {
 protected:
  void SetUp() override {
    if (::access(kServer, X_OK) != 0) GTEST_SKIP() << "nats-server is not installed";
    server_.emplace(kServer,
                    std::vector<std::string>{"-a", "127.0.0.1", "-p", port_, "-js", "-sd", folder_.path() / "store"},
                    folder_.path() / "log");
    session_store::use_cluster_sessions({.kept_for = 24h});
    for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;
         std::this_thread::sleep_for(50ms)) {
      auto opened = nats::NatsConnection::open({.address = {.url = "nats://127.0.0.1:" + port_}, .name = "test"});
      if (!opened) continue;
      connection_ = *std::move(opened);
      streams_ = *nats::Streams::open(*connection_);
      return;
    }
    FAIL() << "the NATS server does not start";
  }
  [[nodiscard]] std::string name(const std::string& session) const {
    return "nats://127.0.0.1:" + port_ + "/ward3/" + session + ".mcap";
  }
  [[nodiscard]] static Result<void> write(const std::string& name, const std::string& content, std::size_t piece,
                                          bool publishes = true) {
    Result<OutputFile> file = OutputFile::create(name, Protection::OfSite);
    if (!file) return file.error();
    for (std::size_t at = 0; at < content.size(); at += piece)
      if (Result<void> done = file->append(std::string_view(content).substr(at, piece)); !done) return done;
    return publishes ? file->publish() : Result<void>{};
  }
  [[nodiscard]] static std::string read(const std::string& name) {
    const auto source = wire::mcap::open_session(name);
    if (!source) return to_string(source.error());
    std::string all;
    return (*source)->read(0, static_cast<std::size_t>((*source)->size()), all) ? all : "unreadable";
  }

  support::TemporaryFolder folder_;
  std::string port_ = std::to_string(20000 + (::getpid() + 23) % 20000);
  std::optional<support::ChildProcess> server_;
  std::unique_ptr<nats::NatsConnection> connection_;
  std::unique_ptr<nats::Streams> streams_;
};

TEST_F(SessionStore, GivesBackWhatWasWrittenInPiecesOfAnySize) {
  int number = 0;
  for (const std::size_t size :
       {std::size_t{1}, std::size_t{512} << 10, (std::size_t{512} << 10) + 1, std::size_t{3'000'000}})
    for (const std::size_t piece : {std::size_t{300'001}, std::size_t{1'500'000}}) {
      const std::string content = noise(size, 1);
      const std::string session = name("s" + std::to_string(++number));
      const Result<void> written = write(session, content, piece);
      ASSERT_TRUE(written) << to_string(written.error());
      EXPECT_EQ(read(session) == content, true) << size << " B in pieces of " << piece;
    }
}

TEST_F(SessionStore, AnEncryptedSessionWhoseLastBlockGrowsIsTheSame) {
  const Result<keys::OwnKey> own = keys::make_private_key("");
  const std::filesystem::path key = folder_.path() / "ward3.key";
  std::ofstream(key) << *keys::public_text(*own->key) << own->text;
  std::filesystem::permissions(key, std::filesystem::perms::owner_read);
  ::setenv("TELEPALP_SITE_KEYS", key.c_str(), 1);
  const std::string content = noise(2'000'000, 2);
  const Result<void> written = write(name("sealed.0001"), content, 33'333);
  ASSERT_TRUE(written) << to_string(written.error());
  EXPECT_EQ(read(name("sealed.0001")) == content, true);
  ::unsetenv("TELEPALP_SITE_KEYS");
  EXPECT_NE(read(name("sealed.0001")).find("is encrypted with the site's key"), std::string::npos);
}

TEST_F(SessionStore, ReadsFromAnyPlace) {
  const std::string content = noise(2'500'000, 3);
  ASSERT_TRUE(write(name("seek"), content, 1 << 20));
  const auto source = wire::mcap::open_session(name("seek"));
  ASSERT_TRUE(source);
  std::mt19937 random(4);
  std::string part;
  for (int i = 0; i < 100; ++i) {
    const std::size_t at = random() % content.size();
    const std::size_t length = random() % std::min<std::size_t>(content.size() - at, 700'000);
    ASSERT_TRUE((*source)->read(at, length, part));
    ASSERT_EQ(part == content.substr(at, length), true) << at << " + " << length;
  }
}

TEST_F(SessionStore, ASessionWithoutConsentIsNotStored) {
  session_store::use_cluster_sessions({});
  const Result<void> written = write(name("none"), "content", 100);
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().what.find("without the patient's consent"), std::string::npos) << written.error().what;
}

TEST_F(SessionStore, NoSessionIsOverwrittenAndARemovedOneIsGone) {
  ASSERT_TRUE(write(name("once"), "content", 100));
  EXPECT_FALSE(write(name("once"), "other", 100));
  EXPECT_EQ(read(name("once")), "content");
  EXPECT_TRUE(session_store::remove_session(name("once")));
  EXPECT_NE(read(name("once")).find("no session of this name"), std::string::npos) << read(name("once"));
  EXPECT_FALSE(session_store::remove_session(name("once")));
}

TEST_F(SessionStore, WhatARecorderLeavesThatIsKilledCanBeRead) {
  const std::string content = noise(1'200'000, 5);
  ASSERT_TRUE(write(name("killed"), content, 100'000, false));
  EXPECT_EQ(read(name("killed")) == content, true);
}

TEST_F(SessionStore, ABlockThatIsMissingOrHasAnotherSizeIsNotRead) {
  ASSERT_TRUE(write(name("holes"), noise(2'000'000, 6), 1 << 20));
  ASSERT_TRUE(streams_->erase("TELEPALP+SESSION+ward3+holes", "telepalp-session.ward3.holes.block.1"));
  ASSERT_TRUE(streams_->store("telepalp-session.ward3.holes.block.2", "short"));
  const auto source = wire::mcap::open_session(name("holes"));
  ASSERT_TRUE(source);
  std::string part;
  EXPECT_TRUE((*source)->read(0, 1000, part));
  EXPECT_FALSE((*source)->read(600'000, 1000, part));
  EXPECT_FALSE((*source)->read(1'100'000, 1000, part));
  EXPECT_TRUE((*source)->read(1'600'000, 1000, part));
}

TEST_F(SessionStore, ASessionWhoseRetentionHasEndedAndADamagedOneAreSaid) {
  ASSERT_TRUE(write(name("old"), "content", 100));
  ASSERT_TRUE(streams_->erase("TELEPALP+SESSION+ward3+old", "telepalp-session.ward3.old.>"));  // as its age does
  EXPECT_NE(read(name("old")).find("retention of this session has ended"), std::string::npos) << read(name("old"));
  ASSERT_TRUE(write(name("bad"), "content", 100));
  for (const std::string& about : {std::string("x"), std::string("TPSTORE1") + std::string(13, '\xff')}) {
    ASSERT_TRUE(streams_->store("telepalp-session.ward3.bad.about", about));
    EXPECT_NE(read(name("bad")).find("description of this session is damaged"), std::string::npos);
  }
}

TEST_F(SessionStore, AFullClusterIsSaid) {
  server_.reset();
  std::ofstream(folder_.path() / "small.conf")
      << "jetstream { store_dir: \"" << (folder_.path() / "small").string() << "\", max_file_store: 1MB }\n";
  server_.emplace(kServer,
                  std::vector<std::string>{"-a", "127.0.0.1", "-p", port_, "-c", folder_.path() / "small.conf"},
                  folder_.path() / "log2");
  std::this_thread::sleep_for(1s);
  const auto began = std::chrono::steady_clock::now();
  const Result<void> written = write(name("large"), noise(4'000'000, 7), 1 << 20);
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().fix.find("JetStream is full"), std::string::npos) << to_string(written.error());
  EXPECT_LT(std::chrono::steady_clock::now() - began, 10s) << "it does not wait for room";
}

TEST(SessionName, HasASiteAndASessionAndNoPassword) {
  ::setenv("TELEPALP_NATS_CREDS", "a.creds", 1);
  const auto name = session_store::parse_name("tls://a,tls://b:5/ward3/anna.0001.mcap");
  ::unsetenv("TELEPALP_NATS_CREDS");
  ASSERT_TRUE(name) << to_string(name.error());
  EXPECT_EQ(name->cluster.url, "tls://a,tls://b:5");
  EXPECT_EQ(name->cluster.credentials, "a.creds");
  EXPECT_EQ(name->site, "ward3");
  EXPECT_EQ(name->session, "anna.0001");
  for (const char* wrong : {"nats://", "nats://h", "nats://h/a.mcap", "nats://h/w/a", "nats://h/w/.mcap",
                            "nats://h/w w/a.mcap", "nats://h/w/a*.mcap", "nats://h/w/>.mcap", "nats://h/w//a.mcap",
                            "nats://anna:secret@h/w/a.mcap", "nats://h/w.x/a.mcap", "nats://h/w/a=b.mcap"})
    EXPECT_FALSE(session_store::parse_name(wrong)) << wrong;
  EXPECT_EQ(to_string(session_store::parse_name("nats://anna:secret@h/w/a.mcap").error()).find("secret"),
            std::string::npos);
}

}  // namespace
