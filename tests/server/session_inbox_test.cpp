// Session files that readers bring in parts.

#include "server/origin/session_inbox.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "messages/station.pb.h"
#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/private_key.h"
#include "proto/wire/mcap/format/byte_source.h"
#include "proto/wire/mcap/sealed/sealed_header.h"
#include "support/program/message_json.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::origin {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class Inbox : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    const std::vector<wire::Message> messages{
        wire::make_message(wire::kStationState, session_time(1'000'000'000), msg::StationState())};
    ASSERT_TRUE(wire::samples::write_file(folder_ / "sample.mcap", messages, {}));
    std::ifstream stream(folder_ / "sample.mcap", std::ios::binary);
    session_.assign(std::istreambuf_iterator<char>(stream), {});
    fs::remove(folder_ / "sample.mcap");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::unique_ptr<SessionInbox> inbox(std::chrono::milliseconds abandoned = 60s) {
    return std::make_unique<SessionInbox>(
        io_, clock_, pool_,
        SessionInbox::Options{.folder = folder_,
                              .say = [this](const std::string& line) { said_.push_back(line); },
                              .on_brought = [this](const std::string& text) { brought_.push_back(text); },
                              .abandoned = abandoned});
  }
  static std::string part(const std::string& name, std::uint64_t from, const std::string& data, bool complete) {
    msg::SessionPart part;
    part.set_name(name);
    part.set_from(from);
    part.set_data(data);
    part.set_complete(complete);
    return program::to_json(part);
  }
  /// The outcome of a part; runs the network until it is known.
  Result<void> outcome(SessionInbox& inbox, const std::string& json) {
    std::optional<Result<void>> done;
    inbox.take(json, "doctor dora", [&](const Result<void>& result) { done = result; });
    io_.restart();
    for (int rounds = 0; !done && rounds < 200; ++rounds) io_.run_one_for(100ms);
    return done.value_or(Error{.what = "no answer", .where = {}, .fix = {}});
  }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
    return names;
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("session_inbox_" + std::to_string(::getpid()));
  std::string session_;
  boost::asio::io_context io_;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work_ = boost::asio::make_work_guard(io_);
  wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  OpeningPool pool_{io_};
  std::vector<std::string> said_, brought_;
};

TEST_F(Inbox, AFileIsCheckedOnAnotherThreadThenListedAndAudited) {
  const auto inbox = this->inbox();
  const std::size_t half = session_.size() / 2;
  EXPECT_TRUE(outcome(*inbox, part("a.mcap", 0, session_.substr(0, half), false)));
  bool answered = false;
  inbox->take(part("a.mcap", half, session_.substr(half), true), "doctor dora",
              [&](const Result<void>&) { answered = true; });
  EXPECT_FALSE(answered) << "the network thread does not wait for the file's index";
  EXPECT_FALSE(outcome(*inbox, part("a.mcap", session_.size(), "x", false))) << "it is being checked";
  for (int rounds = 0; !answered && rounds < 200; ++rounds) io_.run_one_for(100ms);
  EXPECT_EQ(files(), std::vector<std::string>{"a.mcap"});
  ASSERT_EQ(brought_.size(), 1U);
  EXPECT_EQ(brought_[0], "who=doctor dora session=\"a.mcap\" bytes=" + std::to_string(session_.size()));
}

TEST_F(Inbox, WhatIsNoSessionIsRemovedAndAudited) {
  const auto inbox = this->inbox();
  const Result<void> refused = outcome(*inbox, part("a.mcap", 0, "no session", true));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("no session file"), std::string::npos);
  EXPECT_TRUE(files().empty());
  ASSERT_EQ(brought_.size(), 1U);
  EXPECT_NE(brought_[0].find("refused="), std::string::npos) << brought_[0];
}

TEST_F(Inbox, AFileThatIsBrokenOffIsRemovedAndSaid) {
  const auto inbox = this->inbox(50ms);
  EXPECT_TRUE(outcome(*inbox, part("a.mcap", 0, "the first part", false)));
  EXPECT_EQ(files(), std::vector<std::string>{"a.mcap.part.partial"});
  for (int rounds = 0; !files().empty() && rounds < 100; ++rounds) io_.run_one_for(50ms);
  EXPECT_TRUE(files().empty());
  ASSERT_EQ(said_.size(), 1U);
  EXPECT_NE(said_[0].find("a.mcap.part is removed"), std::string::npos) << said_[0];
  EXPECT_FALSE(outcome(*inbox, part("a.mcap", 14, "the second part", false))) << "its beginning is gone";
}

TEST_F(Inbox, WhatAnEarlierServerLeftUnfinishedIsRemoved) {
  for (const char* name : {"old.mcap.part", "young.mcap.part.partial", "other.part", "running.mcap.partial"})
    std::ofstream(folder_ / name) << "half";
  const auto inbox = this->inbox();
  std::vector<std::string> left = files();
  std::ranges::sort(left);
  EXPECT_EQ(left, (std::vector<std::string>{"other.part", "running.mcap.partial"})) << "a recording is not ours";
  EXPECT_EQ(said_.size(), 2U);
}

/// A site's key in use, as telepalp-keys site-key makes it.
class SealedInbox : public Inbox {
 protected:
  void SetUp() override {
    Inbox::SetUp();
    fs::create_directories(keys_);
    const Result<keys::OwnKey> own = keys::make_private_key("");
    const std::string shown = *keys::public_text(*own->key);
    std::ofstream(keys_ / "ward.key") << shown + own->text;
    std::ofstream(keys_ / "ward.pub") << shown;
    fs::permissions(keys_ / "ward.key", fs::perms::owner_read | fs::perms::owner_write);
    use("ward.key");
  }
  void TearDown() override {
    ::unsetenv("TELEPALP_SITE_KEYS");
    fs::remove_all(keys_);
    Inbox::TearDown();
  }
  void use(const char* key) const { ::setenv("TELEPALP_SITE_KEYS", (keys_ / key).c_str(), 1); }
  /// Bytes of a file in the folder.
  [[nodiscard]] std::string stored(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  [[nodiscard]] static bool shows(const std::string& bytes, const std::string& content) {
    return bytes.find(content.substr(0, 24)) != std::string::npos;
  }

  fs::path keys_ = fs::path(testing::TempDir()) / ("session_inbox_keys_" + std::to_string(::getpid()));
};

TEST_F(SealedInbox, ASessionIsEncryptedWhileItComes) {
  const auto inbox = this->inbox();
  const std::size_t half = session_.size() / 2;
  ASSERT_TRUE(outcome(*inbox, part("a.mcap", 0, session_.substr(0, half), false)));
  EXPECT_TRUE(stored("a.mcap.part.partial").starts_with(wire::mcap::kSealedMagic));
  EXPECT_FALSE(shows(stored("a.mcap.part.partial"), session_));
  ASSERT_TRUE(outcome(*inbox, part("a.mcap", half, session_.substr(half), true)));
  EXPECT_EQ(files(), std::vector<std::string>{"a.mcap"});
  EXPECT_FALSE(shows(stored("a.mcap"), session_));
  std::string all;
  const auto source = wire::mcap::open_session(folder_ / "a.mcap");
  ASSERT_TRUE(source) << to_string(source.error());
  ASSERT_TRUE((*source)->read(0, static_cast<std::size_t>((*source)->size()), all));
  EXPECT_EQ(all == session_, true);
}

TEST_F(SealedInbox, AnEncryptedSessionStaysAsItIs) {
  ASSERT_TRUE(outcome(*inbox(), part("a.mcap", 0, session_, true)));
  const std::string sealed = stored("a.mcap");
  ASSERT_TRUE(outcome(*inbox(), part("b.mcap", 0, sealed, true)));
  EXPECT_EQ(stored("b.mcap") == sealed, true);
}

TEST_F(SealedInbox, AServerThatOnlyEncryptsRefusesASessionAndKeepsNothingOfIt) {
  use("ward.pub");
  const Result<void> refused = outcome(*inbox(), part("a.mcap", 0, session_, true));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("decrypts nothing"), std::string::npos) << refused.error().what;
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace telepalp::origin
