// The commands of telepalp-record on files: info, verify, cut, merge; on good files and on damaged ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/json_parser.hpp>
#include <fstream>
#include <random>

#include "clients/record/edit/merge.h"
#include "clients/record/facts/session_facts.h"
#include "clients/record/repair/repair.h"
#include "codec/depth_stream.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/clock.pb.h"
#include "messages/viewer.pb.h"
#include "proto/wire/mcap/reader.h"
#include "tests/clients/recorder_stage.h"

namespace telepalp::record {
namespace {

using wire::samples::kStart_ns;

class Files : public Recorder {
 protected:
  std::filesystem::path write(const std::string& name, const std::vector<wire::Message>& messages,
                              const std::string& source = "synthetic") const {
    wire::SessionInfo info = wire::samples::kInfo;
    info.source = source;
    auto writer = wire::McapWriter::open(in(name), info, {.bytes = 5000});
    EXPECT_TRUE(writer) << to_string(writer.error());
    for (const wire::Message& message : messages) EXPECT_TRUE(writer->write(message));
    EXPECT_TRUE(writer->close());
    return in(name);
  }
  std::string output_of(const std::string& words) const {
    const std::string command =
        kRecorder.string() + " " + words + " > " + in("out").string() + " 2> " + in("log").string();
    exit_code_ = WEXITSTATUS(std::system(command.c_str()));
    return bytes_of(in("out"));
  }
  mutable int exit_code_ = -1;
};

SessionTime at_ms(std::int64_t ms) { return session_time(kStart_ns + ms * 1'000'000); }

wire::Message state(std::int64_t ms, std::uint32_t sender, std::uint64_t sequence) {
  msg::StationState state;
  state.set_stamp_ns(static_cast<std::uint64_t>(kStart_ns + ms * 1'000'000));
  state.set_sender(sender);
  wire::Message message = wire::make_message(wire::kStationState, at_ms(ms), state);
  message.sequence = sequence;
  return message;
}

wire::Message clock_at(std::int64_t ms, std::int64_t utc_ns) {
  msg::Clock clock;
  clock.set_session_ns(static_cast<std::uint64_t>(kStart_ns + ms * 1'000'000));
  clock.set_utc_ns(static_cast<std::uint64_t>(utc_ns));
  return wire::make_message(wire::kClock, at_ms(ms), clock);
}

/// Depth in groups of `group` frames at 30 Hz, with a camera model each second.
std::vector<wire::Message> depth_in_groups(int frames, int group) {
  codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = group});
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24, 800)};
  std::vector<wire::Message> messages;
  for (int frame = 0; frame < frames; ++frame) {
    if (frame % 30 == 0) {
      foxglove::CameraCalibration model;
      messages.push_back(wire::make_message(wire::kCameraInfo, at_ms(frame * 33), model));
    }
    image.samples[static_cast<std::size_t>(frame) % image.samples.size()] = 700;
    msg::DepthImage depth;
    const codec::EncodedDepth encoded = encoder.encode(image);
    depth.set_data(encoded.bytes);
    messages.push_back(wire::make_message(wire::kCameraDepth, at_ms(frame * 33), depth, encoded.key_frame));
  }
  return messages;
}

const SessionFacts::Topic& topic(const SessionFacts& facts, std::string_view name) {
  const auto found = std::find_if(facts.topics.begin(), facts.topics.end(),
                                  [&](const SessionFacts::Topic& each) { return each.name == name; });
  EXPECT_NE(found, facts.topics.end()) << name;
  return *found;
}

TEST_F(Files, InfoCountsBytesGapsLossesAndSteps) {
  std::vector<wire::Message> messages;
  for (std::int64_t number = 1; number <= 100; ++number) {
    if (number > 40 && number <= 45) continue;  // five lost on the way
    messages.push_back(state(number * 10, 7, static_cast<std::uint64_t>(number)));
  }
  messages.push_back(state(900, 8, 101));  // time goes back
  for (int second = 0; second < 3; ++second)
    messages.push_back(clock_at(second * 1000, kStart_ns + second * 1'000'050'000LL + (second == 2 ? 3'000'000 : 0)));
  const auto facts = inspect(write("session.mcap", messages));
  ASSERT_TRUE(facts) << to_string(facts.error());
  const SessionFacts::Topic& states = topic(*facts, "/station/state");
  EXPECT_EQ(states.messages, 96u);
  EXPECT_EQ(states.lost, 5u);
  EXPECT_NEAR(states.longest_gap_s, 0.06, 1e-9);
  EXPECT_EQ(states.back_in_time, 1u);
  std::uint64_t bytes = 0;
  for (const wire::Message& message : messages)
    if (message.topic.name == wire::kStationState.name) bytes += message.payload->size();
  EXPECT_EQ(states.bytes, bytes);
  ASSERT_EQ(facts->peers.size(), 2u) << "two stations are told apart";
  EXPECT_EQ(facts->peers[0].messages + facts->peers[1].messages, 96u);
  ASSERT_TRUE(facts->clock);
  EXPECT_NEAR(facts->clock->largest_step_ms, 3.05, 0.001);
  EXPECT_NEAR(facts->clock->drift_ppm, 1550.0, 0.1);
  const std::string text = in_words(*facts);
  EXPECT_NE(text.find("note: /station/state: 1 message has an earlier time than the message before it"),
            std::string::npos)
      << text;
}

TEST_F(Files, InfoNamesPeersByTheServersStatistics) {
  std::vector<wire::Message> messages{state(0, 7, 1), state(10, 7, 2)};
  for (const std::uint64_t dropped : {4u, 9u}) {
    msg::ServerStats stats;
    auto& subscriber = *stats.add_subscribers();
    subscriber.set_name("telepalp-station");
    subscriber.set_address("10.0.0.6:5000");
    subscriber.set_sender(7);
    subscriber.set_dropped(dropped);
    messages.push_back(wire::make_message(wire::kServerStats, at_ms(20), stats));
  }
  const auto facts = inspect(write("session.mcap", messages));
  ASSERT_TRUE(facts);
  ASSERT_EQ(facts->peers.size(), 1u);
  EXPECT_EQ(facts->peers[0].name, "telepalp-station");
  EXPECT_EQ(facts->peers[0].messages, 2u);
  EXPECT_EQ(facts->peers[0].dropped_before_it, 5u);
}

TEST_F(Files, VerifyAcceptsAWholeFileAndNamesEachDamage) {
  const auto file = write("session.mcap", wire::samples::session(2, 500));
  EXPECT_NE(output_of("verify " + file.string()).find("whole: 320 messages"), std::string::npos);
  EXPECT_EQ(exit_code_, 0);
  std::string bytes = bytes_of(file);
  const auto chunk = wire::McapReader::open(file)->summary().chunks[4];
  bytes[chunk.chunk_start_offset + chunk.chunk_length - 20] ^= 0x55;
  std::ofstream(file, std::ios::binary) << bytes;
  const std::string found = output_of("verify " + file.string());
  EXPECT_EQ(exit_code_, 1);
  EXPECT_NE(found.find("damage: chunk 4: "), std::string::npos) << found;
  EXPECT_NE(found.find("(at byte " + std::to_string(chunk.chunk_start_offset) + ")"), std::string::npos) << found;
  EXPECT_NE(log().find("fix: telepalp-record repair " + file.string()), std::string::npos) << log();
}

TEST_F(Files, VerifyFindsAChunkThatPosesAsARecordOfALaterVersionAndRepairNotesIt) {
  const auto file = write("session.mcap", wire::samples::session(2, 500));
  std::string bytes = bytes_of(file);
  bytes[wire::McapReader::open(file)->summary().chunks[4].chunk_start_offset] = '\x7f';
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_NE(output_of("verify " + file.string()).find("the index of the file counts 320 messages, but"),
            std::string::npos);
  EXPECT_EQ(exit_code_, 1);
  const auto report = repair(file, in("copy.mcap"));
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_FALSE(report->was_whole);
  EXPECT_GT(report->messages, 280u);
}

TEST_F(Files, NoChangedByteIsCalledWholeWhereverItLies) {
  const std::string whole = bytes_of(write("session.mcap", wire::samples::session(1, 500)));
  const auto hurt = in("hurt.mcap");
  std::mt19937 random(28);
  int called_whole = 0;
  for (int round = 0; round < 500; ++round) {
    const std::size_t at = random() % whole.size();
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + random() % 255));
    std::ofstream(hurt, std::ios::binary) << bytes;
    const auto facts = inspect(hurt);
    if (facts && facts->damages_in_all == 0 && ++called_whole > 0)
      ADD_FAILURE() << "byte " << at << " of " << whole.size();
  }
  EXPECT_EQ(called_whole, 0);
}

TEST_F(Files, ADamagedDefinitionOutsideTheChunksIsNamedAndRepairedFromTheSummary) {
  const auto file = write("session.mcap", wire::samples::session(1, 500));
  std::string bytes = bytes_of(file);
  const std::size_t definition = bytes.find("telepalp.msg.");
  ASSERT_LT(definition, wire::McapReader::open(file)->summary().chunks.front().chunk_start_offset);
  bytes[definition] = 'T';
  std::ofstream(file, std::ios::binary) << bytes;
  const auto facts = inspect(file);
  ASSERT_TRUE(facts);
  EXPECT_GT(facts->damages_in_all, 0u);
  const auto report = repair(file, in("copy.mcap"));
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_FALSE(report->was_whole);
  EXPECT_EQ(report->messages, facts->messages);
  EXPECT_EQ(inspect(in("copy.mcap"))->damages_in_all, 0u);
}

TEST_F(Files, VerifyAndInfoNameTheUnfinishedRecording) {
  const auto file = write("session.mcap", wire::samples::session(1, 500));
  std::filesystem::rename(file, file.string() + ".partial");
  for (const std::string command : {"verify ", "info "}) {
    (void)output_of(command + file.string());
    EXPECT_EQ(exit_code_, 1);
    EXPECT_NE(log().find(file.string() + ".partial"), std::string::npos) << log();
    EXPECT_NE(log().find("fix: telepalp-record repair " + file.string() + ", once no recorder"), std::string::npos)
        << log();
  }
  std::filesystem::copy_file(file.string() + ".partial", file);
  EXPECT_NE(output_of("verify " + file.string()).find("a recording of the same name that was not completed"),
            std::string::npos);
  EXPECT_EQ(exit_code_, 0);
}

TEST_F(Files, RepairLeavesOutAnAttachmentThatVerifyNamesAsDamaged) {
  auto writer = wire::McapWriter::open(session(), wire::samples::kInfo);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->add(wire::mcap::Attachment{1, 2, "report.txt", "text/plain", "the attached report"}));
  for (const wire::Message& message : states(0.5)) ASSERT_TRUE(writer->write(message));
  ASSERT_TRUE(writer->close());
  std::string bytes = bytes_of(session());
  bytes[bytes.find("the attached report")] = 'T';
  std::ofstream(session(), std::ios::binary) << bytes;
  ASSERT_EQ(inspect(session())->damages_in_all, 1u);
  const auto report = repair(session(), in("copy.mcap"));
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_FALSE(report->was_whole);
  EXPECT_EQ(report->damages.size(), 1u);
  const auto mended = inspect(in("copy.mcap"));
  ASSERT_TRUE(mended) << to_string(mended.error());
  EXPECT_EQ(mended->damages_in_all, 0u);
  EXPECT_TRUE(mended->attachments.empty());
}

TEST_F(Files, VerifyOfMessagesThatAreNotOfTheirTypeAdvisesNoRepair) {
  std::vector<wire::Message> messages = states(0.5);
  messages[10].payload = std::make_shared<const std::string>("\xff\xff\xff not protobuf");
  (void)output_of("verify " + write("session.mcap", messages).string());
  EXPECT_EQ(exit_code_, 1);
  EXPECT_NE(log().find("1 place is damaged. fix: record again"), std::string::npos) << log();
}

TEST_F(Files, VerifyNamesMessagesThatAreNotOfTheirType) {
  std::vector<wire::Message> messages = states(0.5);
  messages[10].payload = std::make_shared<const std::string>("\xff\xff\xff not protobuf");
  const auto facts = inspect(write("session.mcap", messages));
  ASSERT_TRUE(facts);
  EXPECT_EQ(topic(*facts, "/station/state").unreadable, 1u);
  ASSERT_EQ(facts->damages_in_all, 1u);
  EXPECT_EQ(facts->damages[0], "/station/state: 1 message is damaged, or not of the type telepalp.msg.StationState");
}

TEST_F(Files, AnUnknownSchemaAndAnotherVersionOfOursAreNotesAndNoDamage) {
  auto writer = wire::McapWriter::open(session(), wire::samples::kInfo);
  ASSERT_TRUE(writer);
  const wire::mcap::Schema foreign{1, "some.Thing", "jsonschema", "{}"};
  const wire::mcap::Schema older{2, std::string(wire::kClock.schema), "protobuf", "an older definition"};
  const wire::mcap::StoredChannel other{
      .channel = {.id = 0, .schema_id = 1, .topic = "/other", .message_encoding = "json", .metadata = {}},
      .schema = &foreign,
      .topic = std::nullopt,
      .key_frames = std::nullopt};
  const wire::mcap::StoredChannel clock{.channel = wire::mcap::channel_for(wire::kClock, true),
                                        .schema = &older,
                                        .topic = wire::kClock,
                                        .key_frames = true};
  ASSERT_TRUE(writer->copy({&other, {1, 1, 5, 5, "{}"}}));
  ASSERT_TRUE(writer->copy({&clock, {1, 1, 5, 5, ""}}));
  ASSERT_TRUE(writer->close());
  const auto facts = inspect(session());
  ASSERT_TRUE(facts);
  EXPECT_EQ(facts->damages_in_all, 0u);
  const auto notes = notes_on(*facts);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0], "/clock: recorded by another version of telepalp; its messages may have other fields");
  EXPECT_TRUE(notes[1].starts_with("/other: the topic or its type is not telepalp's")) << notes[1];
}

TEST_F(Files, TruncatedAtEveryHundredthByteRepairGivesBackAWholeFileOrSaysThatNothingIsLeft) {
  const std::string bytes = bytes_of(write("session.mcap", wire::samples::session(1, 1000)));
  std::uint64_t last = 0;
  int repaired = 0;
  for (std::size_t length = 0; length < bytes.size(); length += 100) {
    std::ofstream(in("cut.mcap"), std::ios::binary | std::ios::trunc) << bytes.substr(0, length);
    std::filesystem::remove(in("copy.mcap"));
    const auto report = repair(in("cut.mcap"), in("copy.mcap"));
    if (!report) {
      ASSERT_EQ(last, 0u) << "cut to " << length << ": " << to_string(report.error());
      ASSERT_FALSE(report.error().fix.empty());
      continue;
    }
    ASSERT_GE(report->messages, last) << "cut to " << length;
    last = report->messages;
    const auto facts = inspect(in("copy.mcap"));
    ASSERT_TRUE(facts) << "cut to " << length;
    ASSERT_EQ(facts->damages_in_all, 0u) << "cut to " << length;
    ASSERT_EQ(facts->messages, report->messages);
    ++repaired;
  }
  EXPECT_EQ(last, 160u);
  EXPECT_GT(repaired, 100);
}

TEST_F(Files, ACutKnowsWhichViewerHoldsTheHandAlthoughThatWasPublishedLongBefore) {
  std::vector<wire::Message> messages = depth_in_groups(400, 12);
  msg::HandHolder holder;
  holder.set_viewer(7);
  messages.insert(messages.begin(), wire::make_message(wire::kHandHolder, at_ms(0), holder));
  const auto file = write("session.mcap", messages);
  const auto report = cut(file, in("part.mcap"), {.from = 12s, .topics = TopicFilter("*")});
  ASSERT_TRUE(report) << to_string(report.error());
  auto reader = wire::McapReader::open(in("part.mcap"));
  ASSERT_TRUE(reader);
  bool known = false;
  for (auto next = reader->next(); next && *next; next = reader->next()) {
    EXPECT_GE((**next).published, at_ms(2'000)) << "the holder's message moves to the beginning of the cut";
    known = known || ((**next).topic.name == wire::kHandHolder.name && *(**next).payload == holder.SerializeAsString());
  }
  EXPECT_TRUE(known);
}

TEST_F(Files, ACutHoldsItsTimeAndWhatAPlayerNeedsAtItsBeginning) {
  std::vector<wire::Message> messages = depth_in_groups(90, 12);
  const auto file = write("session.mcap", messages);
  // 1.1 s lies in the group of the frames 24 to 35; the camera model was published at frame 30 last.
  const auto report =
      cut(file, in("part.mcap"), {.from = 1'100ms, .to = Nanoseconds(1'500ms), .topics = TopicFilter("*")});
  ASSERT_TRUE(report) << to_string(report.error());
  auto reader = wire::McapReader::open(in("part.mcap"));
  ASSERT_TRUE(reader);
  codec::DepthDecoder decoder;
  int decoded = 0;
  bool has_model = false;
  for (auto next = reader->next(); next && *next; next = reader->next()) {
    const wire::Message& message = **next;
    EXPECT_LT(message.published, at_ms(1'500));
    has_model = has_model || message.topic.name == wire::kCameraInfo.name;
    if (message.topic.name != wire::kCameraDepth.name) continue;
    msg::DepthImage image;
    ASSERT_TRUE(image.ParseFromString(*message.payload));
    ASSERT_TRUE(decoder.decode(std::as_bytes(std::span(image.data())))) << "frame " << decoded;
    ++decoded;
  }
  EXPECT_TRUE(has_model);
  EXPECT_EQ(decoded, 46 - 24);
  EXPECT_EQ(reader->session()->source, "synthetic");
}

/// For each depth message of `file`, in order: whether it is a key frame, and whether its channel says it.
struct Marks {
  std::vector<bool> key_frames;
  bool marked = true;
  bool true_marks = true;  ///< they agree with the packets
};
Marks marks_in(const std::filesystem::path& file) {
  Marks marks;
  auto reader = wire::McapReader::open(file);
  EXPECT_TRUE(reader) << file;
  for (auto next = reader->next_stored(); next && *next; next = reader->next_stored()) {
    const wire::mcap::StoredMessage& stored = **next;
    if (stored.channel->channel.topic != wire::kCameraDepth.name) continue;
    msg::DepthImage image;
    EXPECT_TRUE(image.ParseFromArray(stored.record.data.data(), static_cast<int>(stored.record.data.size())));
    marks.key_frames.push_back(is_key_frame(stored));
    marks.marked = marks.marked && stored.channel->key_frames.has_value();
    const bool coded_as_key = codec::is_key_frame(std::as_bytes(std::span(image.data())));
    marks.true_marks = marks.true_marks && coded_as_key == marks.key_frames.back();
  }
  return marks;
}

TEST_F(Files, AFileOfAnEarlierReleaseIsReadByItsPacketsAndItsCopiesAreMarked) {
  const std::vector<wire::Message> messages = depth_in_groups(60, 12);
  wire::samples::write_unmarked_file(in("old.mcap"), messages, {.bytes = 5000});
  const Marks old = marks_in(in("old.mcap"));
  EXPECT_FALSE(old.marked);
  EXPECT_TRUE(old.true_marks);
  EXPECT_EQ(std::ranges::count(old.key_frames, true), 5);
  ASSERT_TRUE(cut(in("old.mcap"), in("cut.mcap"), {.from = 1'100ms, .topics = TopicFilter("*")}));
  ASSERT_TRUE(merge({in("old.mcap"), write("new.mcap", messages)}, in("merged.mcap")));
  const std::string bytes = bytes_of(in("old.mcap"));
  std::ofstream(in("torn.mcap"), std::ios::binary) << bytes.substr(0, bytes.size() * 3 / 4);
  ASSERT_TRUE(repair(in("torn.mcap"), in("repaired.mcap")));
  for (const char* copy : {"cut.mcap", "merged.mcap", "repaired.mcap"}) {
    const Marks marks = marks_in(in(copy));
    EXPECT_TRUE(marks.marked) << copy;
    EXPECT_TRUE(marks.true_marks) << copy;
    EXPECT_TRUE(marks.key_frames.front()) << copy;
    EXPECT_GT(marks.key_frames.size(), 30U) << copy;
  }
  const auto facts = inspect(in("old.mcap"));
  ASSERT_TRUE(facts);
  EXPECT_TRUE(topic(*facts, "/camera/depth").begins_with_key_frame);
}

TEST_F(Files, ATopicOfTwoChannelsIsCountedOnceAndTellsThatItBeginsWithoutAKeyFrame) {
  std::vector<wire::Message> messages = depth_in_groups(30, 12);
  const auto whole = inspect(write("whole.mcap", messages));
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->topics.size(), 2U);
  EXPECT_EQ(topic(*whole, "/camera/depth").messages, 30U);
  EXPECT_TRUE(notes_on(*whole).empty());
  std::erase_if(messages,
                [](const wire::Message& message) { return message.topic.predicted && message.published == at_ms(0); });
  const auto facts = inspect(write("without.mcap", messages));
  ASSERT_TRUE(facts);
  ASSERT_EQ(notes_on(*facts).size(), 1U);
  EXPECT_EQ(notes_on(*facts)[0],
            "/camera/depth: begins with a predicted frame, so that nothing can be decoded before "
            "the next key frame");
}

TEST_F(Files, ACutFindsTheKeyFrameOfAGroupThatBeganLongBefore) {
  const auto file = write("session.mcap", depth_in_groups(600, 1000));
  const auto report = cut(file, in("part.mcap"), {.from = 15s, .to = Nanoseconds(16s), .topics = TopicFilter("*")});
  ASSERT_TRUE(report) << to_string(report.error());
  const Marks marks = marks_in(in("part.mcap"));
  ASSERT_FALSE(marks.key_frames.empty());
  EXPECT_TRUE(marks.key_frames.front()) << "15 s before the end of the cut";
  EXPECT_EQ(marks.key_frames.size(), 485U);
}

TEST_F(Files, ACutChoosesTopicsByPatternsAndRefusesAnEmptyOne) {
  const auto file = write("session.mcap", wire::samples::session(1, 1000));
  const auto report = cut(file, in("a.mcap"), {.topics = TopicFilter("*,!/camera/c*")});
  ASSERT_TRUE(report) << to_string(report.error());
  auto reader = wire::McapReader::open(in("a.mcap"));
  EXPECT_EQ(reader->summary().channels.all().size(), 2u);
  const auto none = cut(file, in("b.mcap"), {.topics = TopicFilter("/no*")});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().what.find("no topic of the session matches --topics"), std::string::npos);
  EXPECT_FALSE(cut(file, in("b.mcap"), {.from = 1h}));
  EXPECT_FALSE(std::filesystem::exists(in("b.mcap")));
  EXPECT_FALSE(std::filesystem::exists(in("b.mcap.partial")));
  EXPECT_EQ(run({"cut", file, "--out", in("c.mcap"), "--from", "yesterday"}), 2);
  EXPECT_EQ(run({"cut", file, "--out", in("c.mcap"), "--from", "2s", "--to", "1s"}), 2);
  EXPECT_EQ(run({"cut", file}), 2);
}

TEST_F(Files, PartsOfASessionMergeToTheSessionWithEachMessageOnce) {
  const auto messages = wire::samples::session(3, 1000);
  const auto whole = write("session.mcap", messages);
  ASSERT_TRUE(cut(whole, in("a.mcap"), {.to = Nanoseconds(2s)}));
  ASSERT_TRUE(cut(whole, in("b.mcap"), {.from = 1s}));
  const auto report = merge({in("b.mcap"), in("a.mcap")}, in("merged.mcap"));
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_EQ(report->messages, messages.size());
  EXPECT_GT(report->left_out, 150u);
  auto reader = wire::McapReader::open(in("merged.mcap"));
  for (const wire::Message& message : messages) {
    const auto next = reader->next();
    ASSERT_TRUE(next && *next);
    ASSERT_EQ((*next)->published, message.published);
  }
}

TEST_F(Files, PartsThatHoldTheSameSceneMergeToASessionThatHoldsItOnce) {
  auto writer = wire::McapWriter::open(session(), wire::samples::kInfo);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->add(wire::mcap::Attachment{1, 2, "scene.json", "application/json", "{}"}));
  for (const wire::Message& message : wire::samples::session(3, 1000)) ASSERT_TRUE(writer->write(message));
  ASSERT_TRUE(writer->close());
  ASSERT_TRUE(cut(session(), in("a.mcap"), {.to = Nanoseconds(2s)}));
  ASSERT_TRUE(cut(session(), in("b.mcap"), {.from = 1s}));
  ASSERT_TRUE(merge({in("a.mcap"), in("b.mcap")}, in("merged.mcap")));
  EXPECT_EQ(inspect(in("merged.mcap"))->attachments.size(), 1u);
}

TEST_F(Files, StationsOfTwoServersStayApartInAMerge) {
  const auto a = write("a.mcap", {state(0, 7, 1), state(20, 7, 2)}, "10.0.0.5:7400");
  const auto b = write("b.mcap", {state(10, 7, 1), state(30, 7, 2)}, "10.0.0.9:7400");
  const auto report = merge({a, b}, in("merged.mcap"));
  ASSERT_TRUE(report) << to_string(report.error());
  const auto facts = inspect(in("merged.mcap"));
  ASSERT_TRUE(facts);
  ASSERT_EQ(facts->peers.size(), 2u);
  EXPECT_EQ(facts->peers[0].sender, 7u);
  EXPECT_EQ(facts->peers[1].sender, 1007u);
  EXPECT_EQ(facts->peers[1].messages, 2u);
}

TEST_F(Files, CamerasOfTwoServersAreNotMerged) {
  const auto a = write("a.mcap", wire::samples::session(0.1, 1000), "10.0.0.5:7400");
  const auto b = write("b.mcap", wire::samples::session(0.1, 1000), "10.0.0.9:7400");
  const auto report = merge({a, b}, in("merged.mcap"));
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().what.find("both hold camera images"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(in("merged.mcap.partial")));
  EXPECT_EQ(run({"merge", a, "--out", in("c.mcap")}), 2);
}

TEST_F(Files, CamerasOfTwoServersAreNotMergedBehindASessionWithoutACamera) {
  const auto none = write("none.mcap", {state(0, 7, 1)}, "10.0.0.3:7400");
  const auto a = write("a.mcap", wire::samples::session(0.1, 1000), "10.0.0.5:7400");
  const auto b = write("b.mcap", wire::samples::session(0.1, 1000), "10.0.0.9:7400");
  const auto report = merge({none, a, b}, in("merged.mcap"));
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().where, b.string());
  EXPECT_NE(report.error().what.find(a.string()), std::string::npos);
  EXPECT_TRUE(merge({none, a}, in("merged.mcap")));
}

TEST_F(Files, AnEmptyFileAndAnotherFormatAreNamedByEachCommandAndNothingIsLeftBehind) {
  std::ofstream(in("empty.mcap")).flush();
  std::ofstream(in("other.mcap")) << "PK\x03\x04 something else";
  const auto whole = write("session.mcap", wire::samples::session(0.5, 1000));
  for (const auto& [name, says] :
       {std::pair{"empty.mcap", "is empty"}, std::pair{"other.mcap", "is not an MCAP file"}}) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"info", in(name)},
                                                  {"verify", in(name)},
                                                  {"repair", in(name)},
                                                  {"cut", in(name), "--out", in("out.mcap")},
                                                  {"merge", whole, in(name), "--out", in("out.mcap")}}) {
      EXPECT_EQ(run(words), 1) << words[0] << " " << name;
      EXPECT_NE(log().find(says), std::string::npos) << words[0] << ": " << log();
      EXPECT_NE(log().find(". fix: "), std::string::npos) << words[0] << ": " << log();
    }
  }
  EXPECT_FALSE(std::filesystem::exists(in("out.mcap")));
  EXPECT_FALSE(std::filesystem::exists(in("out.mcap.partial")));
}

TEST_F(Files, OnAFullDiskNoCommandLeavesAFileBehind) {
  const std::string file = write("session.mcap", wire::samples::session(0.1, 500)).string();
  const std::string damaged = in("damaged.mcap").string();
  std::ofstream(damaged, std::ios::binary) << bytes_of(file).substr(0, bytes_of(file).size() - 20);
  const std::string out = in("out.mcap").string();
  for (const std::string& words : {"cut " + file, "merge " + file + " " + file, "repair " + damaged}) {
    const std::string command = "trap '' XFSZ; ulimit -f 2; exec " + kRecorder.string() + " " + words + " --out " +
                                out + " 2> " + in("log").string();
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << words;
    EXPECT_NE(log().find("out.mcap.partial: cannot be written: File too large"), std::string::npos) << log();
    EXPECT_FALSE(std::filesystem::exists(out)) << words;
    EXPECT_FALSE(std::filesystem::exists(out + ".partial")) << words;
  }
}

TEST_F(Files, ANameFromAPeerCannotForgeALineOfInfo) {
  std::vector<wire::Message> messages{state(0, 7, 1)};
  msg::ServerStats stats;
  auto& subscriber = *stats.add_subscribers();
  subscriber.set_name("station\nconsent: yes\x1b[2J");
  subscriber.set_sender(7);
  messages.push_back(wire::make_message(wire::kServerStats, at_ms(20), stats));
  const std::string text = output_of("info " + write("session.mcap", messages).string());
  EXPECT_EQ(text.find("\nconsent: yes"), std::string::npos) << text;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace telepalp::record
