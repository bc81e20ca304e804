// telepalp-record verify and repair on damaged files and on recordings that were cut off: neither calls a loss whole.

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "clients/record/facts/session_facts.h"
#include "clients/record/repair/repair.h"
#include "clients/record/unfinished.h"
#include "proto/wire/mcap/reader.h"
#include "tests/clients/recorder_stage.h"

namespace telepalp::record {
namespace {

constexpr std::size_t kDataEndBytes = wire::mcap::kRecordHeadBytes + 4;
constexpr std::size_t kFooterCrcFromEnd = 4 + 8;  // the CRC and the magic bytes

class Repair : public Recorder {
 protected:
  /// A session with an attachment.
  std::string recorded(double seconds = 4.0) const {
    auto writer = wire::McapWriter::open(session(), wire::samples::kInfo, {.bytes = 5000});
    EXPECT_TRUE(writer) << to_string(writer.error());
    EXPECT_TRUE(writer->add(wire::mcap::Attachment{1, 2, "scene.textproto", "text/plain", "name: 'x'"}));
    for (const wire::Message& message : wire::samples::session(seconds, 500)) EXPECT_TRUE(writer->write(message));
    EXPECT_TRUE(writer->close());
    return bytes_of(session());
  }
  wire::mcap::Summary summary() const { return wire::McapReader::open(session())->summary(); }
  void write(const std::filesystem::path& file, const std::string& bytes) const {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  }
  std::filesystem::path partial() const { return session().string() + ".partial"; }
  /// Replaces the session by the recorder's file before the end of the session was written, with `bytes`.
  void leave_unfinished(const std::string& bytes) const {
    std::filesystem::remove(session());
    write(partial(), bytes);
  }
  std::string verified(const std::filesystem::path& file) const {
    const std::string command =
        kRecorder.string() + " verify " + file.string() + " > " + in("out").string() + " 2> " + in("log").string();
    exit_code_ = WEXITSTATUS(std::system(command.c_str()));
    return bytes_of(in("out"));
  }
  mutable int exit_code_ = -1;
};

/// Adds `by` to the length of the record at `offset`.
void lengthen(std::string& bytes, std::size_t offset, unsigned by) {
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < 8; ++i)
    length |= std::uint64_t{static_cast<unsigned char>(bytes[offset + 1 + i])} << (8 * i);
  length += by;
  for (std::size_t i = 0; i < 8; ++i) bytes[offset + 1 + i] = static_cast<char>(length >> (8 * i));
}

TEST_F(Repair, SaysHowManyMessagesAreLostAndTheCopySaysSoEverAfter) {
  std::string bytes = recorded();
  const auto chunk = summary().chunks[4];
  const std::uint64_t all = summary().statistics.message_count;
  bytes[chunk.chunk_start_offset + chunk.chunk_length - 20] ^= 0x55;
  write(session(), bytes);
  ASSERT_EQ(run({"repair", session(), "--out", in("copy.mcap")}), 0) << log();
  const std::uint64_t kept = wire::McapReader::open(in("copy.mcap"))->summary().statistics.message_count;
  ASSERT_LT(kept, all);
  EXPECT_NE(log().find("copy.mcap: recovered " + std::to_string(kept) + " of " + std::to_string(all) + " messages; " +
                       std::to_string(all - kept) + " are lost"),
            std::string::npos)
      << log();
  const std::string said = verified(in("copy.mcap"));
  EXPECT_EQ(exit_code_, 0) << log();
  EXPECT_NE(said.find("note: repaired from session.mcap: 1 place was damaged, and " + std::to_string(all - kept) +
                      " messages are lost"),
            std::string::npos)
      << said;
}

TEST_F(Repair, OfAFileWithoutItsSummaryLosesNothingAndSaysSo) {
  const std::string bytes = recorded();
  const std::uint64_t all = summary().statistics.message_count;
  write(session(), bytes.substr(0, bytes.size() - 60));
  ASSERT_EQ(run({"repair", session(), "--out", in("copy.mcap")}), 0) << log();
  EXPECT_NE(log().find("recovered all " + std::to_string(all) + " messages"), std::string::npos) << log();
}

TEST_F(Repair, ACrcThatWasLostIsADamageOfASessionOfOurs) {
  const std::string whole = recorded();
  const std::size_t data_crc = summary().start - 4;
  for (const std::size_t crc : {data_crc, whole.size() - kFooterCrcFromEnd}) {
    std::string bytes = whole;
    bytes.replace(crc, 4, 4, '\0');
    write(session(), bytes);
    EXPECT_EQ(inspect(session())->damages_in_all, 1u) << crc;
    const auto report = repair(session(), in("copy.mcap"));
    ASSERT_TRUE(report) << to_string(report.error());
    EXPECT_FALSE(report->was_whole);
    EXPECT_EQ(report->lost, 0u);
    std::filesystem::remove(in("copy.mcap"));
  }
}

TEST_F(Repair, ALengthThatReachesOverOtherChunksLosesNoneOfThem) {
  const std::string whole = recorded();
  const auto chunks = summary().chunks;
  const auto attachment = summary().attachments.front();
  const std::uint64_t all = summary().statistics.message_count;
  for (const std::uint64_t damaged : {attachment.offset, chunks[2].chunk_start_offset}) {
    std::string bytes = whole;
    lengthen(bytes, damaged, 9'000);
    write(session(), bytes);
    const auto report = repair(session(), in("copy.mcap"));
    ASSERT_TRUE(report) << to_string(report.error());
    EXPECT_GE(report->messages + 80, all) << "at most the messages of one chunk";
    EXPECT_EQ(report->messages + *report->lost, all);
    std::filesystem::remove(in("copy.mcap"));
  }
}

TEST_F(Repair, AnUnfinishedRecordingIsRemovedWhenOnlyItsEndIsMissing) {
  const std::string whole = recorded();
  const auto last = summary().chunks.back();
  const std::size_t data_end = summary().start - kDataEndBytes;
  for (const std::size_t length : {data_end, last.chunk_start_offset + 5, last.chunk_start_offset + 100}) {
    leave_unfinished(whole.substr(0, length));
    ASSERT_EQ(run({"repair", session()}), 0) << log();
    EXPECT_FALSE(std::filesystem::exists(partial())) << length << ": " << log();
    EXPECT_NE(
        verified(session()).find("its recorder was interrupted, and the messages of the last moments are missing"),
        std::string::npos);
  }
}

TEST_F(Repair, AnUnfinishedRecordingWhoseLastChunkIsDamagedIsKept) {
  const std::string whole = recorded();
  const auto last = summary().chunks.back();
  const std::size_t data_end = summary().start - kDataEndBytes;
  std::string bytes = whole.substr(0, data_end);
  lengthen(bytes, last.chunk_start_offset, 1'000'000);
  leave_unfinished(bytes);
  ASSERT_EQ(run({"repair", session()}), 0) << log();
  EXPECT_NE(log().find("1 place was damaged, so the recorder's own file is kept"), std::string::npos) << log();
  EXPECT_TRUE(bytes_of(partial()) == bytes);
}

TEST_F(Repair, AnUnfinishedRecordingWithAChangedDefinitionIsKeptAndTheTopicNamed) {
  Server server;
  const auto recorder = start(server);
  publish_slowly(server, states(0.2));
  ASSERT_TRUE(wait_for([&] { return flushed_messages(partial()) == 20; }));
  recorder->signal(SIGKILL);
  EXPECT_EQ(recorder->wait(10s), 128 + SIGKILL);
  const std::string whole = bytes_of(partial());
  for (const char* text : {"/station/state", "telepalp.msg.StationState", "indentation_m"}) {
    std::string bytes = whole;
    const std::size_t place = bytes.find(text);
    ASSERT_NE(place, std::string::npos) << text;
    bytes[place + 5] ^= 0x01;
    leave_unfinished(bytes);
    ASSERT_EQ(run({"repair", session()}), 0) << log();
    EXPECT_NE(log().find("is not that of this version: a byte of it has changed"), std::string::npos) << log();
    EXPECT_TRUE(bytes_of(partial()) == bytes) << text;
    const auto mended = inspect(session());
    ASSERT_TRUE(mended) << to_string(mended.error());
    ASSERT_EQ(mended->topics.size(), 1u);
    EXPECT_EQ(mended->topics[0].name, "/station/state");
    EXPECT_FALSE(mended->topics[0].has_other_version) << text;
  }
  leave_unfinished(whole);
  ASSERT_EQ(run({"repair", session()}), 0) << log();
  EXPECT_FALSE(std::filesystem::exists(partial())) << log();
}

TEST_F(Repair, AnUnfinishedRecordingWithChangedMetadataIsKeptAndSaysWhichMayBeWrong) {
  const std::string whole = recorded();
  for (const std::string& text : {wire::samples::kInfo.source, wire::samples::kInfo.scene}) {
    std::string bytes = whole.substr(0, summary().chunks.back().chunk_start_offset);
    const std::size_t place = bytes.find(text);
    ASSERT_NE(place, std::string::npos) << text;
    bytes[place + text.size() / 2] ^= 0x01;
    leave_unfinished(bytes);
    ASSERT_EQ(run({"repair", session()}), 0) << log();
    EXPECT_NE(log().find("the metadata telepalp.session are damaged"), std::string::npos) << log();
    EXPECT_TRUE(std::filesystem::exists(partial())) << "a damaged file is kept";
    std::filesystem::remove(partial());
    write(session(), whole);
  }
}

TEST_F(Repair, EveryCommandThatMeetsAnUnfinishedRecordingNamesIt) {
  leave_unfinished(recorded().substr(0, 9'000));
  for (const std::vector<std::string>& words : {std::vector<std::string>{"info", session()},
                                                {"verify", session()},
                                                {"cut", session(), "--out", in("part.mcap")},
                                                {"merge", session(), session(), "--out", in("both.mcap")}}) {
    EXPECT_EQ(run(words), 1);
    EXPECT_NE(log().find(partial().string() + " holds what was"), std::string::npos) << words[0] << ": " << log();
    EXPECT_NE(log().find("fix: telepalp-record repair " + session().string()), std::string::npos) << log();
  }
}

TEST_F(Repair, AnUnfinishedRecordingBesideAFinishedOneIsNotedByEachCommandOnOneFile) {
  write(partial(), recorded().substr(0, 9'000));
  for (const char* command : {"info", "verify", "repair"}) {
    const std::string said = in("said").string();
    const std::string line = kRecorder.string() + " " + command + " " + session().string() + " > " + said + " 2>&1";
    EXPECT_EQ(std::system(line.c_str()), 0) << command;
    EXPECT_NE(bytes_of(said).find(partial().string() + " lies beside it"), std::string::npos) << bytes_of(said);
  }
}

}  // namespace
}  // namespace telepalp::record
