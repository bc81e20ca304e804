// Session files compared with npm's @mcap/core: it reads telepalp's files, and telepalp reads its files.

#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/reading/stream_reader.h"
#include "tests/proto/mcap_samples.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::wire {
namespace {

using google::protobuf::Descriptor;

std::string base64(const std::string& bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (std::size_t next = 0; next < 3; ++next)
      three = three << 8 | (at + next < bytes.size() ? static_cast<unsigned char>(bytes[at + next]) : 0u);
    for (std::size_t letter = 0; letter < 4; ++letter)
      text += at + letter > bytes.size() ? '=' : kLetters[three >> (18 - 6 * letter) & 63];
  }
  return text;
}

std::string json_of(const Message& message) {
  const auto* const prototype =
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(descriptor_of(message.topic));
  const std::unique_ptr<google::protobuf::Message> decoded(prototype->New());
  EXPECT_TRUE(decoded->ParseFromString(*message.payload));
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string json;
  EXPECT_TRUE(google::protobuf::util::MessageToJsonString(*decoded, &json, options).ok());
  return json;
}

/// How its channel marks the message.
std::string frames_of(const Message& message) {
  if (!message.topic.predicted) return "not marked";
  return message.key_frame ? "key" : "predicted";
}

/// A file's content as JSON, for the scripts.
std::string twin(const std::vector<Message>& messages, std::size_t chunks) {
  std::string json = "{\"chunks\": " + std::to_string(chunks) + ", \"schemas\": {";
  std::map<std::string_view, std::string> schemas;
  for (const Message& message : messages)
    schemas[message.topic.schema] = base64(file_descriptor_set(*descriptor_of(message.topic)));
  std::string comma;
  for (const auto& [name, data] : schemas) {
    json += std::exchange(comma, ", ") + "\"" + std::string(name) + "\": \"" + data + "\"";
  }
  json += "}, \"messages\": [";
  comma.clear();
  std::map<std::string_view, int> sequences;
  for (const Message& message : messages) {
    json += std::exchange(comma, ",\n") + "{\"topic\": \"" + std::string(message.topic.name) + "\", \"schema\": \"" +
            std::string(message.topic.schema) + "\", \"time\": \"" + std::to_string(to_nanoseconds(message.published)) +
            "\", \"sequence\": " + std::to_string(++sequences[message.topic.name]) + ", \"payload\": \"" +
            base64(*message.payload) + "\", \"frames\": \"" + frames_of(message) +
            "\", \"fields\": " + json_of(message) + "}";
  }
  return json + "]}";
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

int run_script(const std::string& script, const std::vector<std::string>& arguments,
               const std::filesystem::path& log = {}) {
  std::vector<std::string> all{"node", TELEPALP_SOURCE_DIR "/tests/npm/" + script};
  all.insert(all.end(), arguments.begin(), arguments.end());
  support::ChildProcess node("/usr/bin/env", all, log);
  return node.wait(std::chrono::seconds(60)).value_or(-1);
}

TEST(McapOracle, TheJavaScriptReaderFindsEveryCountByteAndFieldThatWeWrote) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "ours.mcap";
  auto messages = samples::session(4);
  for (std::size_t at = 0; at < messages.size(); ++at)
    messages[at].key_frame = !messages[at].topic.predicted || at % 5 == 0;
  ASSERT_TRUE(samples::write_file(file, messages, {.bytes = 60'000}));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  write_text(folder.path() / "twin.json", twin(messages, reader->summary().chunks.size()));
  EXPECT_EQ(run_script("check_mcap.mjs", {file, folder.path() / "twin.json"}), 0);
}

TEST(McapOracle, TheOracleNoticesOneWrongByte) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "ours.mcap";
  auto messages = samples::session(1);
  ASSERT_TRUE(samples::write_file(file, messages));
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader);
  std::string payload = *messages[7].payload;
  payload.back() = static_cast<char>(payload.back() ^ 1);
  messages[7].payload = std::make_shared<const std::string>(payload);
  write_text(folder.path() / "twin.json", twin(messages, reader->summary().chunks.size()));
  const auto log = folder.path() / "log";
  EXPECT_EQ(run_script("check_mcap.mjs", {file, folder.path() / "twin.json"}, log), 1);
  EXPECT_NE(samples::bytes_of(log).find("payload of message 7"), std::string::npos);
}

/// Options of @mcap/core's writer, and the number of messages to find.
struct Foreign {
  const char* name;
  const char* options;
};
void PrintTo(const Foreign& foreign, std::ostream* out) { *out << foreign.name; }

class ForeignMcap : public testing::TestWithParam<Foreign> {
 protected:
  /// A file written by the script with `options`; it contains `messages`.
  std::filesystem::path make(const std::string& options) {
    write_text(folder_.path() / "twin.json", twin(messages_, 0));
    write_text(folder_.path() / "options.json", options);
    const auto file = folder_.path() / "theirs.mcap";
    EXPECT_EQ(run_script("write_mcap.mjs", {file, folder_.path() / "twin.json", folder_.path() / "options.json"}), 0);
    return file;
  }
  const std::vector<Message> messages_ = samples::session(2, 200);
  support::TemporaryFolder folder_;
};

#define TELEPALP_COMPRESSOR "\"compressor\": \"" TELEPALP_BINARY_DIR "/bin/mcap_compressor\""

TEST_P(ForeignMcap, IsReadWhole) {
  const auto file = make(GetParam().options);
  auto reader = McapReader::open(file);
  ASSERT_TRUE(reader) << to_string(reader.error());
  std::size_t read = 0;
  for (; read < messages_.size(); ++read) {
    const auto next = reader->next();
    ASSERT_TRUE(next) << to_string(next.error());
    ASSERT_TRUE(*next) << "after " << read << " messages";
    ASSERT_EQ((*next)->topic.name, messages_[read].topic.name);
    ASSERT_EQ((*next)->published, messages_[read].published);
    ASSERT_EQ(*(*next)->payload, *messages_[read].payload);
  }
  ASSERT_EQ(reader->summary().metadata.size(), 1u);
  const auto note = reader->read(reader->summary().metadata.front());
  ASSERT_TRUE(note);
  EXPECT_EQ(note->values.at("from"), "@mcap/core");
  ASSERT_EQ(reader->summary().attachments.size(), 1u);
  const auto attachment = reader->read(reader->summary().attachments.front());
  ASSERT_TRUE(attachment) << to_string(attachment.error());
  EXPECT_EQ(attachment->data, "attached");
}

INSTANTIATE_TEST_SUITE_P(
    WrittenByMcapCore, ForeignMcap,
    testing::Values(Foreign{"PlainChunks", R"({"chunkSize": 1048576, "compression": ""})"},
                    Foreign{"TinyPlainChunks", R"({"chunkSize": 10, "compression": ""})"},
                    Foreign{"ZstdChunks", R"({"chunkSize": 20000, "compression": "zstd", )" TELEPALP_COMPRESSOR "}"},
                    Foreign{"Lz4Chunks", R"({"chunkSize": 20000, "compression": "lz4", )" TELEPALP_COMPRESSOR "}"},
                    Foreign{"NoSummaryOffsets",
                            R"({"chunkSize": 20000, "compression": "", "writer": {"useSummaryOffsets": false}})"},
                    Foreign{"NoMessageIndex",
                            R"({"chunkSize": 20000, "compression": "", "writer": {"useMessageIndex": false}})"}),
    [](const auto& chosen) { return std::string(chosen.param.name); });

TEST_F(ForeignMcap, ACompressionThatIsNotReadIsNamed) {
  auto reader = McapReader::open(make(R"({"chunkSize": 20000, "compression": "snappy"})"));
  ASSERT_TRUE(reader);
  const auto next = reader->next();
  ASSERT_FALSE(next);
  EXPECT_NE(next.error().what.find("snappy"), std::string::npos) << to_string(next.error());
  EXPECT_NE(next.error().fix.find("lz4"), std::string::npos);  // a repair would not help
}

TEST_F(ForeignMcap, WithoutChunksIsReadFromFrontToBackAndTheIndexedReaderSaysWhyNot) {
  const auto file = make(R"({"chunkSize": 1, "compression": "", "writer": {"useChunks": false}})");
  const auto indexed = McapReader::open(file);
  ASSERT_FALSE(indexed);
  EXPECT_NE(indexed.error().what.find("no index"), std::string::npos);
  auto stream = McapStreamReader::open(file);
  ASSERT_TRUE(stream);
  std::size_t read = 0;
  for (auto next = stream->next(); next && *next; next = stream->next()) {
    ASSERT_EQ((*next)->record.data, *messages_[read].payload);
    ++read;
  }
  EXPECT_EQ(read, messages_.size());
  EXPECT_TRUE(stream->complete());
}

}  // namespace
}  // namespace telepalp::wire
