// telepalp-export --deidentify: no text of people, places and computers is in the copy, and depth, forces and times are
// as recorded.

#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "codec/color.h"
#include "codec/depth_stream.h"
#include "codec/video.h"
#include "foxglove/CompressedVideo.pb.h"
#include "messages/clock.pb.h"
#include "messages/inside.pb.h"
#include "proto/wire/camera/color_message.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/notes_file.h"
#include "proto/wire/mcap/reader.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/child_process.h"
#include "tools/export_tool/deidentify/color_mosaic.h"
#include "tools/export_tool/deidentify/plain_jpeg.h"
#include "tools/export_tool/deidentify/text_rules.h"
#include "tools/export_tool/deidentify_command.h"
#include "where.h"

namespace telepalp::export_tool {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using namespace std::chrono_literals;
using wire::samples::kFrame_ns;
using wire::samples::kStart_ns;

constexpr const char* kPerson = "Annabel Bergström";  ///< planted in each text of the session
constexpr std::array kPlanted{"Annabel", "Bergstr", "ward7.hospital.example", "10.4.7.11", "secret-token", "diabetes"};

std::string planted(const FieldDescriptor& field) {
  return std::string(kPerson) + " at ward7.hospital.example (10.4.7.11), secret-token, diabetes: " + field.name();
}

/// Fills each text of `message` and of all messages in it, but for coded data, with planted words.
void plant(Message& message, int depth = 0) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  for (int index = 0; index < message.GetDescriptor()->field_count(); ++index) {
    const FieldDescriptor* const field = message.GetDescriptor()->field(index);
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
      const TextRule rule = rule_of(*field);
      if (rule == TextRule::Data) continue;
      field->is_repeated() ? reflection.AddString(&message, field, planted(*field))
                           : reflection.SetString(&message, field, planted(*field));
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && depth < 4) {
      plant(
          field->is_repeated() ? *reflection.AddMessage(&message, field) : *reflection.MutableMessage(&message, field),
          depth + 1);
    }
  }
  reflection.MutableUnknownFields(&message)->AddLengthDelimited(5000, kPerson);
}

std::unique_ptr<Message> empty_message(const wire::Topic& topic) {
  return std::unique_ptr<Message>(
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(wire::descriptor_of(topic))->New());
}

DepthImage noisy_depth(int frame) {
  DepthImage image{.width = 32, .height = 24, .unit_m = 0.001, .samples = std::vector<std::uint16_t>(32 * 24)};
  std::mt19937 noise(static_cast<unsigned>(frame));
  for (std::uint16_t& sample : image.samples) sample = static_cast<std::uint16_t>(700 + noise() % 80);
  return image;
}

/// A picture whose left half is red and right half is blue, with fine stripes.
ColorImage striped(int frame) {
  ColorImage color{.width = 64, .height = 48, .rgb = std::vector<std::uint8_t>(64 * 48 * 3)};
  for (int place = 0; place < 64 * 48; ++place)
    color.rgb[static_cast<std::size_t>(3 * place) + (place % 64 < 32 ? 0 : 2)] =
        static_cast<std::uint8_t>((place + frame) % 2 == 0 ? 255 : 55);
  return color;
}

std::string with_comment(const std::string& jpeg) {
  std::string comment = "\xff\xfe";
  comment += '\0';
  comment += static_cast<char>(2 + std::string(kPerson).size());
  return jpeg.substr(0, 2) + comment + kPerson + jpeg.substr(2) + kPerson;
}

/// All text that a reader of the file can get at: its raw bytes, and what its chunks hold uncompressed.
std::string everything_in(const std::filesystem::path& file) {
  std::string all = wire::samples::bytes_of(file);
  auto reader = wire::McapReader::open(file);
  EXPECT_TRUE(reader) << to_string(reader.error());
  for (const auto& [id, stored] : reader->summary().channels.all()) {
    all += stored.channel.topic + "\n" + (stored.schema ? stored.schema->name + stored.schema->data : "");
    for (const auto& [key, value] : stored.channel.metadata) all += key + value + "\n";
  }
  for (const auto& index : reader->summary().metadata) {
    const auto metadata = reader->read(index);
    for (const auto& [key, value] : metadata->values) all += key + "=" + value + "\n";
  }
  for (const auto& index : reader->summary().attachments) all += reader->read(index)->data;
  for (auto next = reader->next_stored(); next && *next; next = reader->next_stored()) all += (**next).record.data;
  return all;
}

class Deidentify : public testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_.path() / name; }

  void SetUp() override {
    auto writer = wire::McapWriter::open(
        in("session.mcap"), {.program = "telepalp-record",
                             .version = "0.2.0",
                             .commit = "1a2b3c4",
                             .source = "ward7.hospital.example:7400",
                             .scene = "# for Annabel Bergström\nname: \"Annabel\" purpose: \"diabetes\"\n"
                                      "effects { skin { tissue: \"relaxed_belly\" linear_stiffness_N_per_m: 321 } }\n"
                                      "effects { solid { name: \"Annabel's liver\" } }\n",
                             .recorded_by = "doctor Annabel Bergström",
                             .consent = "signed by Annabel Bergström, secret-token"});
    ASSERT_TRUE(writer) << to_string(writer.error());
    for (const wire::Message& message : messages()) ASSERT_TRUE(writer->write(message));
    ASSERT_TRUE(writer->add(wire::mcap::Attachment{.name = "Annabel.txt", .media_type = {}, .data = "diabetes"}));
    ASSERT_TRUE(writer->add(wire::mcap::Metadata{"telepalp.merge", {{"file_0", "Annabel.mcap"}}}));
    ASSERT_TRUE(writer->add(wire::mcap::Metadata{
        "telepalp.recording", {{"gaps", "2"}, {"depth", "temporal, lossless"}, {"note", "Annabel"}}}));
    ASSERT_TRUE(add_foreign(*writer));
    ASSERT_TRUE(writer->close());
    std::ofstream(in("session.mcap.notes.json"))
        << R"({"notes":[{"atS":1,"text":"diabetes","who":"Annabel","number":1}]})";
  }

  /// A message of each topic with all its texts planted, and images and forces over time.
  static std::vector<wire::Message> messages() {
    std::vector<wire::Message> all;
    codec::DepthEncoder encoder({.mode = codec::DepthMode::Temporal, .key_every = 8});
    codec::ColorVideoEncoder video({});
    for (int frame = 0; frame < 20; ++frame) {
      const SessionTime now = session_time(kStart_ns + frame * kFrame_ns);
      msg::DepthImage depth;
      plant(depth);
      depth.clear_bound();
      depth.set_frame_id("camera_depth");
      depth.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
      const codec::EncodedDepth encoded = encoder.encode(noisy_depth(frame));
      depth.set_data(encoded.bytes);
      all.push_back(wire::make_message(wire::kCameraDepth, now, depth, encoded.key_frame));
      foxglove::CompressedImage color;
      plant(color);
      color.set_data(with_comment(codec::encode_color(striped(frame), 90)));
      all.push_back(wire::make_message(wire::kCameraColor, now, color));
      foxglove::CompressedVideo packet;
      plant(packet);
      packet.set_format(codec::kVideoFormat);
      const codec::EncodedVideo coded = video.encode(striped(frame), now);
      packet.set_data(coded.bytes);
      all.push_back(wire::make_message(wire::kCameraColorVideo, now, packet, coded.key_frame));
      msg::StationState state;
      plant(state);
      state.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
      state.mutable_force_n()->set_y(0.25 * frame);
      all.push_back(wire::make_message(wire::kStationState, now, state));
    }
    const SessionTime end = session_time(kStart_ns + 20 * kFrame_ns);
    for (const wire::Topic& topic : wire::kTopics) {
      if (topic.predicted || topic.name == wire::kCameraColor.name) continue;
      const std::unique_ptr<Message> message = empty_message(topic);
      plant(*message);
      if (auto* const image = dynamic_cast<msg::UltrasoundImage*>(message.get()))
        image->set_jpeg(with_comment(codec::encode_gray(std::vector<std::uint8_t>(64, 90), 8, 8)));
      all.push_back(wire::make_message(topic, end, *message));
    }
    return all;
  }

  static Result<void> add_foreign(wire::McapWriter& writer) {
    const wire::mcap::StoredChannel channel{.channel = {.id = 0,
                                                        .schema_id = 0,
                                                        .topic = "/Annabel/voice",
                                                        .message_encoding = "json",
                                                        .metadata = {{"who", "Annabel"}}},
                                            .schema = nullptr,
                                            .topic = {},
                                            .key_frames = {}};
    return writer.copy({.channel = &channel,
                        .record = {.channel_id = 0,
                                   .sequence = 1,
                                   .log_time = kStart_ns,
                                   .publish_time = kStart_ns,
                                   .data = "Annabel says secret-token"}});
  }

  support::TemporaryFolder folder_;
};

void expect_nothing_planted(const std::string& text) {
  for (const char* word : kPlanted) EXPECT_EQ(text.find(word), std::string::npos) << word;
}

TEST_F(Deidentify, TheCheckFindsWhatThisTestPlants) {
  const std::string all = everything_in(in("session.mcap"));
  for (const char* word : kPlanted) EXPECT_NE(all.find(word), std::string::npos) << word;
}

TEST_F(Deidentify, NoTextOfPeoplePlacesOrComputersIsInTheCopy) {
  for (const ColorRule color : {ColorRule::Remove, ColorRule::Blur}) {
    const auto out = in(color == ColorRule::Remove ? "out.mcap" : "blurred.mcap");
    const auto report = write_deidentified(in("session.mcap"), out, color);
    ASSERT_TRUE(report) << to_string(report.error());
    expect_nothing_planted(everything_in(out));
    expect_nothing_planted(in_words(*report, color));
    EXPECT_FALSE(std::filesystem::exists(out.string() + ".notes.json"));
    EXPECT_EQ(report->attachments, 1u);
    EXPECT_EQ(report->notes, 1u);
    EXPECT_EQ(report->topics.at(kOtherTopics).removed, 1u);
    EXPECT_EQ(report->topics.at("/camera/color").blurred, color == ColorRule::Blur ? 20u : 0u);
    EXPECT_EQ(report->topics.at("/camera/color/video").blurred, color == ColorRule::Blur ? 20u : 0u);
    for (const auto& [topic, count] : report->topics) EXPECT_EQ(count.unreadable, 0u) << topic;
  }
}

/// Clears each text but coded data, so that two messages can be compared without their texts.
void clear_texts(Message& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  reflection.MutableUnknownFields(&message)->Clear();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING && rule_of(*field) != TextRule::Data)
      reflection.ClearField(&message, field);
    else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && field->is_repeated())
      for (int index = 0; index < reflection.FieldSize(message, field); ++index)
        clear_texts(*reflection.MutableRepeatedMessage(&message, field, index));
    else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
      clear_texts(*reflection.MutableMessage(&message, field));
  }
}

std::vector<wire::Message> without_color_and_speech(const std::filesystem::path& file) {
  auto reader = wire::McapReader::open(file);
  EXPECT_TRUE(reader) << to_string(reader.error());
  std::vector<wire::Message> all;
  for (auto next = reader->next(); next && *next; next = reader->next())
    if (const wire::Topic& topic = (**next).topic; !wire::carries_color(topic) && !topic.spoken) all.push_back(**next);
  return all;
}

TEST_F(Deidentify, NothingThatWasSaidIsInTheCopy) {
  const Result<Deidentified> report = write_deidentified(in("session.mcap"), in("out.mcap"), ColorRule::Blur);
  ASSERT_TRUE(report);
  for (const wire::Topic& topic : wire::kTopics) {
    if (!topic.spoken) continue;
    EXPECT_GT(report->topics.at(std::string(topic.name)).removed, 0u) << topic.name;
    EXPECT_EQ(report->topics.at(std::string(topic.name)).kept, 0u) << topic.name;
  }
  auto reader = wire::McapReader::open(in("out.mcap"));
  ASSERT_TRUE(reader);
  for (auto next = reader->next(); next && *next; next = reader->next()) EXPECT_FALSE((**next).topic.spoken);
}

TEST_F(Deidentify, AllNumbersDepthForcesAndTimesAreAsRecorded) {
  ASSERT_TRUE(write_deidentified(in("session.mcap"), in("out.mcap"), ColorRule::Blur));
  const std::vector<wire::Message> before = without_color_and_speech(in("session.mcap"));
  const std::vector<wire::Message> after = without_color_and_speech(in("out.mcap"));
  ASSERT_EQ(before.size(), after.size());
  codec::DepthReader depths;
  int frame = 0;
  for (std::size_t place = 0; place < before.size(); ++place) {
    EXPECT_EQ(before[place].topic.name, after[place].topic.name);
    EXPECT_EQ(before[place].published, after[place].published);
    EXPECT_EQ(before[place].sequence, after[place].sequence);
    EXPECT_EQ(before[place].key_frame, after[place].key_frame);
    const std::unique_ptr<Message> one = empty_message(before[place].topic);
    const std::unique_ptr<Message> other = empty_message(before[place].topic);
    ASSERT_TRUE(one->ParseFromString(*before[place].payload));
    ASSERT_TRUE(other->ParseFromString(*after[place].payload));
    if (const auto* const depth = dynamic_cast<msg::DepthImage*>(other.get())) {
      const auto decoded = depths.read(std::as_bytes(std::span(depth->data())));
      ASSERT_TRUE(decoded) << to_string(decoded.error());
      EXPECT_EQ(decoded->image.samples, noisy_depth(frame++).samples);
    }
    clear_texts(*one);
    clear_texts(*other);
    EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(*one, *other)) << before[place].topic.name;
  }
  EXPECT_EQ(frame, 20);
}

TEST_F(Deidentify, TheSceneKeepsItsStiffnessAndNumbersItsNames) {
  ASSERT_TRUE(write_deidentified(in("session.mcap"), in("out.mcap"), ColorRule::Remove));
  const auto session = wire::McapReader::open(in("out.mcap"))->session();
  ASSERT_TRUE(session);
  EXPECT_NE(session->scene.find("linear_stiffness_N_per_m: 321"), std::string::npos) << session->scene;
  EXPECT_NE(session->scene.find("relaxed_belly"), std::string::npos) << session->scene;
  EXPECT_NE(session->scene.find("name: \"name 1\""), std::string::npos) << session->scene;
  EXPECT_EQ(session->program, "telepalp-record");
  EXPECT_EQ(session->recorded_by + session->consent + session->source, "");
}

TEST_F(Deidentify, OneNameHasOneNumberInAllMessages) {
  MessageCleaner cleaner;
  msg::StationCompensation placed;
  placed.add_objects()->set_name("liver of Annabel");
  placed.add_objects()->set_name("mass");
  cleaner.clean(placed);
  msg::InnerStructures inside;
  inside.add_structures()->set_name("mass");
  cleaner.clean(inside);
  EXPECT_EQ(placed.objects(0).name(), "name 1");
  EXPECT_EQ(placed.objects(1).name(), "name 2");
  EXPECT_EQ(inside.structures(0).name(), "name 2");
}

TEST_F(Deidentify, EachRuleNamesAFieldAndEachKeptWordOfTelepalpsOwnStays) {
  for (const char* word : {"camera_depth", "jpeg", "vp8", "temporal", "depth lattice", "nanoflann KD-tree",
                           "PCL KD-tree", "PCL organised search", "single-frame", "plumb_bob", "relaxed_belly", "none"})
    EXPECT_TRUE(may_stay(TextRule::Word, word)) << word;
  for (const char* text : {"Annabel", "ward7.hospital.example", "10.4.7.11", "a b c d e f", "", "x\ny"})
    EXPECT_FALSE(may_stay(TextRule::Word, text)) << text;
  EXPECT_TRUE(may_stay(TextRule::Software, "telepalp-station 0.2.0, commit 1a2b3c4d"));
  EXPECT_FALSE(may_stay(TextRule::Software, "telepalp-station 0.2.0 of Annabel"));
}

TEST_F(Deidentify, ABlurredImageHasOneColourInEachSquareAndNoStripes) {
  const ColorImage blurred = mosaic(striped(0));
  ASSERT_EQ(blurred.rgb.size(), striped(0).rgb.size());
  for (std::size_t place = 0; place < blurred.rgb.size(); place += 3) {
    const bool is_left = place / 3 % 64 < 32;
    EXPECT_EQ(blurred.rgb[place + (is_left ? 0 : 2)], 155);
    EXPECT_EQ(blurred.rgb[place + (is_left ? 2 : 0)], 0);
  }
  EXPECT_EQ(mosaic(ColorImage{.width = 1, .height = 1, .rgb = {1, 2, 3}}).rgb, (std::vector<std::uint8_t>{1, 2, 3}));
}

TEST_F(Deidentify, APictureLosesItsCommentsAndNothingElse) {
  const std::string picture = codec::encode_gray(std::vector<std::uint8_t>(64 * 64, 90), 64, 64);
  const std::string plain = plain_jpeg(with_comment(picture));
  EXPECT_EQ(plain, plain_jpeg(picture));
  const auto before = codec::decode_color(std::as_bytes(std::span(picture)));
  const auto after = codec::decode_color(std::as_bytes(std::span(plain)));
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->rgb, after->rgb);
  for (std::size_t length = 0; length < plain.size(); ++length)
    EXPECT_EQ(plain_jpeg(std::string_view(plain).substr(0, length)), "") << "cut off at " << length;
}

TEST_F(Deidentify, TheProgramSaysWhatItRemovedAndOverwritesNothing) {
  const auto run = [&](const std::vector<std::string>& words) {
    support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-export", words, in("log"));
    return program.wait(20s).value_or(-1);
  };
  const std::string session = in("session.mcap");
  EXPECT_EQ(run({session, "--deidentify", in("out.mcap"), "--out", in("report.txt")}), 0);
  const std::string report = wire::samples::bytes_of(in("report.txt"));
  EXPECT_NE(report.find("/camera/color: none kept, 20 removed"), std::string::npos) << report;
  EXPECT_NE(report.find("/camera/depth: 20 messages kept"), std::string::npos) << report;
  EXPECT_NE(report.find("text removed: telepalp.msg.CaptureStatus.source"), std::string::npos) << report;
  EXPECT_NE(report.find("still in the copy: dates and times"), std::string::npos) << report;
  const std::string copy = wire::samples::bytes_of(in("out.mcap"));
  EXPECT_EQ(run({session, "--deidentify", in("out.mcap")}), 1) << "a file is overwritten";
  EXPECT_EQ(run({session, "--deidentify", session}), 1);
  EXPECT_EQ(run({session, "--deidentify", in("new.mcap"), "--out", in("new.mcap")}), 2);
  EXPECT_EQ(run({session, "--deidentify", in("new.mcap"), "--color", "pink"}), 2);
  EXPECT_EQ(run({session, "--csv", "/clock", "--color", "blur"}), 2);
  EXPECT_EQ(wire::samples::bytes_of(in("out.mcap")), copy);
  EXPECT_FALSE(std::filesystem::exists(in("new.mcap")));
}

TEST_F(Deidentify, ADamagedSessionIsCopiedAsFarAsItCanBeRead) {
  std::string bytes = wire::samples::bytes_of(in("session.mcap"));
  const auto chunk = wire::McapReader::open(in("session.mcap"))->summary().chunks.front();
  bytes[chunk.chunk_start_offset + chunk.chunk_length / 2] ^= 0x55;
  std::ofstream(in("damaged.mcap"), std::ios::binary) << bytes;
  const auto report = write_deidentified(in("damaged.mcap"), in("out.mcap"), ColorRule::Remove);
  ASSERT_TRUE(report) << to_string(report.error());
  EXPECT_GE(report->damaged, 1u);
  expect_nothing_planted(everything_in(in("out.mcap")));
}

}  // namespace
}  // namespace telepalp::export_tool
