// Notes on a session are kept in a file beside it, which each change replaces as a whole.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "proto/keys/seal/site_key.h"
#include "proto/keys/secret/private_key.h"
#include "proto/wire/mcap/format/place.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/sealed/sealed_text.h"
#include "proto/wire/mcap/writer.h"
#include "proto/wire/topics.h"
#include "server/playback/session_notes.h"
#include "support/program/message_json.h"

namespace telepalp::playback {
namespace {

constexpr std::chrono::system_clock::time_point kNow{std::chrono::seconds(1'772'366'400)};  // 2026-03-01 12:00 UTC

struct Notes : ::testing::Test {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("telepalp_notes_" + std::to_string(::getpid()));
  const std::filesystem::path session = folder / "a.mcap";
  const std::filesystem::path file = folder / "a.mcap.notes.json";

  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  SessionNotes open() const {
    auto notes = SessionNotes::open(session, 60.0, {});
    EXPECT_TRUE(notes) << to_string(notes.error());
    return *notes;
  }
  void write(const std::string& text) const { std::ofstream(file) << text; }
};

TEST_F(Notes, AreInOrderOfTimeAndOpenAgainFromTheFile) {
  SessionNotes notes = open();
  EXPECT_FALSE(std::filesystem::exists(file)) << "looking writes nothing";
  ASSERT_TRUE(notes.apply(R"({"at_s": 12.5, "text": "rebound here"})", "\"Ada\" (qa)", kNow));
  ASSERT_TRUE(notes.apply(R"({"at_s": 3, "text": "<b>5 \u00b5m</b>"})", "Bo", kNow));
  const std::string json = program::to_json(open().all());
  EXPECT_EQ(json, program::to_json(notes.all()));
  EXPECT_LT(json.find("5 µm"), json.find("rebound"));
  EXPECT_NE(json.find(R"("written":"2026-03-01T12:00:00Z")"), std::string::npos) << json;
  EXPECT_NE(json.find("Ada"), std::string::npos);
}

TEST_F(Notes, ARemovedNotesNumberIsNotGivenAgain) {
  SessionNotes notes = open();
  ASSERT_TRUE(notes.apply(R"({"at_s": 1, "text": "one"})", "", kNow));
  ASSERT_TRUE(notes.apply(R"({"at_s": 2, "text": "two"})", "", kNow));
  ASSERT_TRUE(notes.apply(R"({"remove": 2})", "", kNow));
  ASSERT_TRUE(open().apply(R"({"at_s": 2, "text": "three"})", "", kNow));
  const std::string json = program::to_json(open().all());
  EXPECT_EQ(json.find("two"), std::string::npos);
  EXPECT_NE(json.find(R"("number":"3")"), std::string::npos) << json;
}

TEST_F(Notes, WrongCommandsAreNamedAndChangeNothing) {
  SessionNotes notes = open();
  const std::string long_text(wire::kMostNoteText_B + 1, 'x');
  for (const std::string& wrong :
       {std::string("nonsense"), std::string(R"({"at_s": 1})"), std::string(R"({"text": "no time"})"),
        std::string(R"({"at_s": 61, "text": "behind the end"})"), std::string(R"({"at_s": -1, "text": "before"})"),
        std::string(R"({"at_s": "NaN", "text": "never"})"), std::string(R"({"at_s": 1, "text": ""})"),
        std::string(R"({"at_s": 1, "text": "two\nlines"})"), std::string(R"({"remove": 1})"),
        R"({"at_s": 1, "text": ")" + long_text + R"("})"})
    EXPECT_FALSE(notes.apply(wrong, "", kNow)) << wrong;
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(notes.apply("{}", "", kNow)) << "an empty command asks for the notes";
}

TEST_F(Notes, AreBoundedInNumber) {
  std::string full = R"({"notes": [)";
  for (int number = 1; number <= wire::kMostNotes; ++number)
    full += (number > 1 ? "," : "") + (R"({"number": ")" + std::to_string(number)) + R"(", "at_s": 1, "text": "x"})";
  write(full + "]}");
  SessionNotes notes = open();
  const auto refused = notes.apply(R"({"at_s": 1, "text": "one more"})", "", kNow);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("1000"), std::string::npos);
}

TEST_F(Notes, AFileThatHoldsNoNotesIsNamedAndNotOverwritten) {
  for (const std::string& wrong : {std::string("{\"notes\": 3}"), std::string(5'000'000, ' '),
                                   std::string(R"({"notes": [{"at_s": "NaN", "text": "never"}]})")}) {
    write(wrong);
    const auto opened = SessionNotes::open(session, 60.0, {});
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().where.find("a.mcap.notes.json"), std::string::npos);
    EXPECT_EQ(std::filesystem::file_size(file), wrong.size());
  }
}

/// A session that is encrypted with a site's key.
struct SealedNotes : Notes {
  void SetUp() override {
    Notes::SetUp();
    make_key("ward");
    make_key("other");
    use("ward.key");
    auto writer = std::move(wire::McapWriter::open(session, {}).value());
    ASSERT_TRUE(writer.close());
    ASSERT_NE(wire::mcap::header_of(session).value(), std::nullopt);
  }
  void TearDown() override {
    ::unsetenv("TELEPALP_SITE_KEYS");
    Notes::TearDown();
  }
  void make_key(const std::string& name) const {
    const Result<keys::OwnKey> own = keys::make_private_key("");
    const std::string shown = *keys::public_text(*own->key);
    std::ofstream(folder / (name + ".key")) << shown + own->text;
    std::ofstream(folder / (name + ".pub")) << shown;
    std::filesystem::permissions(folder / (name + ".key"),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  }
  void use(const char* key) const { ::setenv("TELEPALP_SITE_KEYS", (folder / key).c_str(), 1); }
  [[nodiscard]] std::string stored() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(SealedNotes, AreEncryptedAsTheirSessionIsAndOpenAgain) {
  SessionNotes notes = open();
  ASSERT_TRUE(notes.apply(R"({"at_s": 3, "text": "a mass under the ninth rib"})", "doctor Anna", kNow));
  ASSERT_TRUE(notes.apply(R"({"at_s": 4, "text": "no rebound"})", "doctor Anna", kNow));
  EXPECT_TRUE(stored().starts_with(wire::mcap::kSealedMagic));
  for (const char* shown : {"rib", "rebound", "Anna", "notes"}) EXPECT_EQ(stored().find(shown), std::string::npos);
  EXPECT_EQ(program::to_json(open().all()), program::to_json(notes.all()));
}

TEST_F(SealedNotes, AnotherKeyDoesNotOpenThemAndDoesNotOverwriteThem) {
  ASSERT_TRUE(open().apply(R"({"at_s": 3, "text": "one"})", "", kNow));
  const std::string before = stored();
  for (const char* key : {"other.key", "ward.pub"}) {
    use(key);
    const auto opened = SessionNotes::open(session, 60.0, {});
    ASSERT_FALSE(opened) << key;
    EXPECT_NE(opened.error().fix.find("name the private part"), std::string::npos) << to_string(opened.error());
  }
  EXPECT_EQ(stored() == before, true);
}

TEST_F(SealedNotes, WhoeverHasThePublicPartAloneWritesWhatTheOwnerReads) {
  SessionNotes notes = open();
  use("ward.pub");
  ASSERT_TRUE(notes.apply(R"({"at_s": 3, "text": "one"})", "", kNow));
  use("ward.key");
  EXPECT_EQ(open().all().notes(0).text(), "one");
}

TEST_F(SealedNotes, ADamagedFileIsNamedAndNotOverwritten) {
  ASSERT_TRUE(open().apply(R"({"at_s": 3, "text": "one"})", "", kNow));
  const std::string whole = stored();
  std::string altered = whole;
  altered.back() = static_cast<char>(altered.back() ^ 1);
  for (const std::string& damaged : {altered, whole.substr(0, whole.size() - 1), whole.substr(0, 100)}) {
    write(damaged);
    const auto opened = SessionNotes::open(session, 60.0, {});
    ASSERT_FALSE(opened);
    EXPECT_NE(to_string(opened.error()).find("a.mcap.notes.json"), std::string::npos) << to_string(opened.error());
    EXPECT_EQ(stored() == damaged, true);
  }
}

TEST_F(SealedNotes, ThoseOfAnOlderVersionAreReadAndEncryptedWithTheNextChange) {
  write(R"({"notes": [{"number": "1", "at_s": 1, "text": "old"}], "last_number": "1"})");
  SessionNotes notes = open();
  ASSERT_EQ(notes.all().notes_size(), 1);
  ASSERT_TRUE(notes.apply(R"({"at_s": 3, "text": "new"})", "", kNow));
  EXPECT_EQ(stored().find("old"), std::string::npos);
  EXPECT_EQ(open().all().notes_size(), 2);
}

TEST_F(Notes, OnASessionInAClusterAreRefusedWithTheWayOut) {
  wire::mcap::add_place({.beginning = "nats://", .open = {}, .create = {}});
  auto notes = SessionNotes::open("nats://127.0.0.1/ward3/a.mcap", 60.0, {});
  ASSERT_TRUE(notes);
  const Result<void> refused = notes->apply(R"({"at_s": 1, "text": "one"})", "", kNow);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().fix.find("telepalp-record copy"), std::string::npos);
}

TEST_F(Notes, BeginWithTheMomentsThatWereMarkedDuringTheSession) {
  auto writer = std::move(wire::McapWriter::open(session, {}).value());
  const auto put = [&](std::uint64_t at_ns, std::uint64_t published_ns, const char* text) {
    msg::LiveNote note;
    note.set_at_ns(at_ns);
    note.set_text(text);
    note.set_who("doctor Anna");
    const auto published = session_time(static_cast<std::int64_t>(published_ns));
    EXPECT_TRUE(writer.write(wire::make_message(wire::kSessionNotes, published, note)));
  };
  put(1'000'000'000, 1'500'000'000, "before the recording began");
  put(9'000'000'000, 9'100'000'000, "");
  put(7'500'000'000, 9'200'000'000, "tender here");
  put(UINT64_MAX, 9'300'000'000, "of a damaged writer");
  put(9'000'000'000, 9'400'000'000, "two\nlines");
  ASSERT_TRUE(writer.close());
  const auto live = wire::live_notes(session);
  ASSERT_TRUE(live) << to_string(live.error());
  auto notes = SessionNotes::open(session, 60.0, *live);
  ASSERT_TRUE(notes);
  const auto text_at = [&](int at) { return notes->all().notes(at).text(); };
  ASSERT_EQ(notes->all().notes_size(), 3) << program::to_json(notes->all());
  EXPECT_EQ(notes->all().notes(0).at_s(), 0.0);
  EXPECT_NEAR(notes->all().notes(1).at_s(), 6.0, 1e-9) << "since the first message of the file";
  EXPECT_EQ(text_at(1), "tender here");
  EXPECT_EQ(text_at(2), "marked");
  EXPECT_EQ(notes->all().notes(2).who(), "doctor Anna");
  ASSERT_TRUE(notes->apply(R"({"remove": 2})", "Bo", kNow));
  EXPECT_EQ(SessionNotes::open(session, 60.0, *live)->all().notes_size(), 2) << "a removed mark does not come back";
}

TEST_F(Notes, AnUnwritableFolderLeavesTheNotesAsTheyWere) {
  auto notes = SessionNotes::open(folder / "missing" / "a.mcap", 60.0, {});
  ASSERT_TRUE(notes);
  const std::string before = program::to_json(notes->all());
  EXPECT_FALSE(notes->apply(R"({"at_s": 1, "text": "one"})", "", kNow));
  EXPECT_EQ(program::to_json(notes->all()), before);
}

}  // namespace
}  // namespace telepalp::playback
