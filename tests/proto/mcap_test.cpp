#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "tests/proto/mcap_samples.h"

namespace telepalp::wire {
namespace {

using samples::bytes_of;
using samples::fresh_file;
using samples::kInfo;
using samples::write_file;

std::vector<Message> all_of(McapReader& reader) {
  std::vector<Message> messages;
  for (;;) {
    auto next = reader.next();
    EXPECT_TRUE(next) << to_string(next.error());
    if (!next || !*next) return messages;
    messages.push_back(**next);
  }
}

void expect_equal(const std::vector<Message>& got, const std::vector<Message>& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (std::size_t at = 0; at < got.size(); ++at) {
    ASSERT_EQ(got[at].topic.name, expected[at].topic.name) << at;
    ASSERT_EQ(got[at].published, expected[at].published) << at;
    ASSERT_EQ(*got[at].payload, *expected[at].payload) << at;
    ASSERT_EQ(got[at].key_frame, expected[at].key_frame) << at;
  }
}

TEST(Mcap, WhatWasWrittenIsReadBackInOrderThroughTheIndex) {
  const auto messages = samples::session(5);
  const auto file = fresh_file("round_trip.mcap");
  ASSERT_TRUE(write_file(file, messages, {.bytes = 20'000}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  EXPECT_GT(reader->summary().chunks.size(), 20u);
  EXPECT_EQ(reader->summary().statistics.message_count, messages.size());
  EXPECT_EQ(reader->summary().channels.all().size(), 3u);
  expect_equal(all_of(*reader), messages);
}

/// Depth at 10 Hz, in which each `group`th message is a key frame, and states beside it.
std::vector<Message> in_groups(int count, int group) {
  std::vector<Message> messages;
  for (int number = 0; number < count; ++number) {
    const SessionTime at = session_time(1'700'000'000'000'000'000 + number * 100'000'000LL);
    msg::DepthImage depth;
    depth.set_sequence(static_cast<std::uint64_t>(number));
    messages.push_back(make_message(kCameraDepth, at, depth, number % group == 0));
    messages.push_back(make_message(kStationState, at, msg::StationState()));
  }
  return messages;
}

TEST(Mcap, TheKeyFramesOfATopicHaveAChannelOfTheirOwn) {
  const auto messages = in_groups(50, 12);
  const auto file = fresh_file("key_channel.mcap");
  ASSERT_TRUE(write_file(file, messages, {.bytes = 500}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  std::map<std::optional<bool>, std::uint64_t> of_depth;
  for (const auto& [id, stored] : reader->summary().channels.all())
    if (stored.topic->name == kCameraDepth.name)
      of_depth[stored.key_frames] = reader->summary().statistics.channel_message_counts.at(id);
  EXPECT_EQ(of_depth, (std::map<std::optional<bool>, std::uint64_t>{{true, 5}, {false, 45}}));
  expect_equal(all_of(*reader), messages);
  auto stream = McapStreamReader::open(file);
  ASSERT_TRUE(stream);
  std::size_t predicted = 0;
  for (auto next = stream->next(); next && *next; next = stream->next()) predicted += is_key_frame(**next) ? 0 : 1;
  EXPECT_EQ(predicted, 45u);
}

TEST(Mcap, TheIndexOfThatChannelFindsTheLastKeyFrameBeforeAnyInstant) {
  const auto messages = in_groups(50, 12);
  const auto file = fresh_file("key_index.mcap");
  ASSERT_TRUE(write_file(file, messages, {.bytes = 500}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  EXPECT_GT(reader->summary().chunks.size(), 5u);
  std::optional<SessionTime> last;
  for (const Message& message : messages) {
    if (message.topic.name != kCameraDepth.name) continue;
    EXPECT_EQ(reader->last_key_frame(kCameraDepth, message.published), last);
    if (message.key_frame) last = message.published;
    EXPECT_EQ(reader->last_key_frame(kCameraDepth, message.published + Nanoseconds(1)), last);
  }
  EXPECT_FALSE(reader->last_key_frame(kCameraColor, session_time(INT64_MAX)));
}

TEST(Mcap, ADamagedMarkIsNoticedAndADamagedIndexIsNoKeyFrame) {
  const auto file = fresh_file("damaged_mark.mcap");
  ASSERT_TRUE(write_file(file, in_groups(50, 12)));
  const std::string bytes = bytes_of(file);
  const auto mark = bytes.find(std::string("\x06\0\0\0frames", 10));  // a key of a channel's metadata
  ASSERT_NE(mark, std::string::npos);
  std::string changed = bytes;
  changed[mark + 4] = 'F';
  auto stream = McapStreamReader::open(mcap::in_memory(changed, "damaged.mcap"));
  ASSERT_TRUE(stream);
  const auto first = stream->next();
  ASSERT_FALSE(first);
  EXPECT_NE(first.error().what.find("a channel is damaged"), std::string::npos) << first.error().what;

  auto whole = McapReader::open(mcap::in_memory(bytes, "whole.mcap"));
  ASSERT_TRUE(whole);
  changed = bytes;
  for (const mcap::ChunkIndex& chunk : whole->summary().chunks)
    for (const auto& [channel, offset] : chunk.message_index_offsets) changed[offset] = '\x7f';
  auto damaged = McapReader::open(mcap::in_memory(changed, "damaged.mcap"));
  ASSERT_TRUE(damaged);
  EXPECT_FALSE(damaged->last_key_frame(kCameraDepth, session_time(INT64_MAX)));
}

TEST(Mcap, AFileStatesItsProgramAndItsSource) {
  const auto file = fresh_file("session_info.mcap");
  ASSERT_TRUE(write_file(file, samples::session(0.1)));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  const auto session = reader->session();
  ASSERT_TRUE(session);
  EXPECT_EQ(session->program, kInfo.program);
  EXPECT_EQ(session->version, kInfo.version);
  EXPECT_EQ(session->commit, kInfo.commit);
  EXPECT_EQ(session->source, kInfo.source);
  EXPECT_EQ(session->scene, kInfo.scene);
}

TEST(Mcap, AnAttachmentComesBackWhole) {
  const auto file = fresh_file("attachment.mcap");
  auto writer = McapWriter::open(file, kInfo);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->add(mcap::Attachment{1, 2, "abdomen.scene.textproto", "text/plain", "skin { }"}));
  ASSERT_TRUE(writer->close());
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->summary().attachments.size(), 1u);
  const auto attachment = reader->read(reader->summary().attachments.front());
  ASSERT_TRUE(attachment) << to_string(attachment.error());
  EXPECT_EQ(attachment->name, "abdomen.scene.textproto");
  EXPECT_EQ(attachment->data, "skin { }");
}

TEST(Mcap, TheSameMessagesGiveTheSameBytes) {
  const auto first = fresh_file("same_1.mcap");
  const auto second = fresh_file("same_2.mcap");
  ASSERT_TRUE(write_file(first, samples::session(2)));
  ASSERT_TRUE(write_file(second, samples::session(2)));
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(Mcap, ALossOnTheWayShowsAsAGapInTheSequence) {
  const auto file = fresh_file("gap.mcap");
  auto messages = samples::session(0.1);
  messages.erase(messages.begin() + 3, messages.end());
  for (Message& message : messages) message.topic = kClock;
  messages[0].sequence = 41;
  messages[1].sequence = 44;
  messages[2].sequence = 45;
  ASSERT_TRUE(write_file(file, messages));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  const auto got = all_of(*reader);
  ASSERT_EQ(got.size(), 3u);
  EXPECT_EQ(got[0].sequence, 41u);
  EXPECT_EQ(got[1].sequence, 44u);
}

TEST(Mcap, AnEmptySessionIsAWholeFile) {
  const auto file = fresh_file("empty_session.mcap");
  ASSERT_TRUE(write_file(file, {}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  EXPECT_TRUE(all_of(*reader).empty());
}

TEST(Mcap, MessagesWrittenOutOfOrderAreReadInOrderOfTime) {
  const auto file = fresh_file("out_of_order.mcap");
  auto messages = samples::session(4, 500);
  const auto in_order = messages;
  std::mt19937 random(7);
  for (std::size_t at = 40; at < messages.size(); ++at)  // late messages cross the borders of chunks
    if (random() % 4 == 0) std::swap(messages[at], messages[at - 1 - random() % 40]);
  ASSERT_TRUE(write_file(file, messages, {.bytes = 3'000}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  const auto got = all_of(*reader);
  ASSERT_EQ(got.size(), in_order.size());
  for (std::size_t at = 1; at < got.size(); ++at) ASSERT_LE(got[at - 1].published, got[at].published) << at;
}

TEST(Mcap, ATimeRangeAndATopicReadOnlyWhatTheyAskFor) {
  const auto messages = samples::session(6);
  const auto file = fresh_file("range.mcap");
  ASSERT_TRUE(write_file(file, messages, {.bytes = 20'000}));
  const SessionTime from = messages.front().published + std::chrono::seconds(2);
  const SessionTime until = from + std::chrono::seconds(1);
  std::vector<Message> expected;
  for (const Message& message : messages)
    if (message.published >= from && message.published < until && message.topic.name.starts_with("/camera/"))
      expected.push_back(message);
  ASSERT_GT(expected.size(), 50u);
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  reader->select({.topics = {"/camera/*"}, .from = from, .until = until});
  expect_equal(all_of(*reader), expected);
  reader->select({.topics = {"/no/such/topic"}});
  EXPECT_TRUE(all_of(*reader).empty());
  reader->select({});
  expect_equal(all_of(*reader), messages);
}

TEST(Mcap, AChunkIsClosedAfterASecondEvenWhenItIsSmall) {
  const auto file = fresh_file("one_second.mcap");
  ASSERT_TRUE(write_file(file, samples::session(10, 5000)));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  EXPECT_GE(reader->summary().chunks.size(), 9u);
  EXPECT_LE(reader->summary().chunks.size(), 11u);
}

TEST(Mcap, TwoSendersWhoseClocksDifferDoNotMakeAChunkOfEveryMessage) {
  const auto file = fresh_file("skewed.mcap");
  auto messages = samples::session(3, 5000);
  for (Message& message : messages)
    if (message.topic.name == kStationState.name) message.published += std::chrono::hours(1);
  ASSERT_TRUE(write_file(file, messages));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  EXPECT_LE(reader->summary().chunks.size(), 4u);
  EXPECT_EQ(all_of(*reader).size(), messages.size());
}

TEST(Mcap, UntilItIsClosedARecordingIsCalledPartialAndIsReadable) {
  const auto file = fresh_file("unfinished.mcap");
  const auto messages = samples::session(1, 500);
  auto writer = McapWriter::open(file, kInfo);
  ASSERT_TRUE(writer);
  for (const Message& message : messages) ASSERT_TRUE(writer->write(message));
  ASSERT_TRUE(writer->flush());
  EXPECT_FALSE(std::filesystem::exists(file));
  {
    auto stream = McapStreamReader::open(file.string() + ".partial");
    ASSERT_TRUE(stream);
    std::size_t read = 0;
    for (auto next = stream->next(); next && *next; next = stream->next()) ++read;
    EXPECT_EQ(read, messages.size());
    EXPECT_FALSE(stream->complete());
  }
  ASSERT_TRUE(writer->close());
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".partial"));
}

TEST(Mcap, NoFileOfAnyoneIsOverwritten) {
  const auto file = fresh_file("taken.mcap");
  std::ofstream(file) << "mine";
  const auto over_final = McapWriter::open(file, kInfo);
  ASSERT_FALSE(over_final);
  EXPECT_NE(to_string(over_final.error()).find("exists already"), std::string::npos);
  EXPECT_EQ(bytes_of(file), "mine");
  std::filesystem::rename(file, file.string() + ".partial");
  const auto over_partial = McapWriter::open(file, kInfo);
  ASSERT_FALSE(over_partial);
  EXPECT_NE(over_partial.error().fix.find("telepalp-record repair"), std::string::npos);
}

TEST(Mcap, AFolderThatIsNotThereIsNamed) {
  const auto writer = McapWriter::open(fresh_file("no_such_folder") / "a.mcap", kInfo);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().where.find("no_such_folder"), std::string::npos);
}

TEST(Mcap, AFullDiskIsAnErrorAndWhatWasWrittenBeforeBecomesAWholeFile) {
  const auto file = fresh_file("full.mcap");
  // A limit of the file size simulates a full disk: the write fails in the middle of a record.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  auto writer = McapWriter::open(file, kInfo, {.bytes = 50'000});
  ASSERT_TRUE(writer);
  rlimit limit = before;
  limit.rlim_cur = 220'000;
  setrlimit(RLIMIT_FSIZE, &limit);
  std::optional<Error> error;
  for (const Message& message : samples::session(5))
    if (const auto written = writer->write(message); !written) error = written.error();
  setrlimit(RLIMIT_FSIZE, &before);
  const auto closed = writer->close();
  std::signal(SIGXFSZ, old_handler);
  ASSERT_TRUE(error);
  EXPECT_NE(error->fix.find("free space"), std::string::npos) << to_string(*error);
  EXPECT_FALSE(closed);  // the error is still reported, although the file could be finished
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  EXPECT_EQ(reader->summary().chunks.size(), 4u);
  EXPECT_EQ(all_of(*reader).size(), reader->summary().statistics.message_count);
}

TEST(Mcap, EveryTopicHasATypeAndItsSchemaCarriesTheImports) {
  for (const Topic& topic : kTopics) {
    google::protobuf::FileDescriptorSet set;
    ASSERT_TRUE(set.ParseFromString(file_descriptor_set(*descriptor_of(topic)))) << topic.name;
    google::protobuf::DescriptorPool pool;  // contains only the types of the set
    for (const auto& file : set.file()) ASSERT_NE(pool.BuildFile(file), nullptr) << topic.name << " " << file.name();
    EXPECT_NE(pool.FindMessageTypeByName(std::string(topic.schema)), nullptr) << topic.name;
  }
}

}  // namespace
}  // namespace telepalp::wire
