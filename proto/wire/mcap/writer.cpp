#include "proto/wire/mcap/writer.h"

#include <cstdio>

#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/wire/mcap/format/stored_time.h"

namespace telepalp::wire {
namespace {

/// A record's bytes with a fixed id, so that records with equal content are equal.
template <class Record>
std::string identity(Record record) {
  record.id = 0;
  std::string bytes;
  mcap::append(bytes, record);
  return bytes;
}

constexpr const char* kCheckSum = "crc32";

/// CRC-32 of the record's name and its other entries, each text followed by a zero byte, in hexadecimal digits.
std::string check_sum_of(const mcap::Metadata& metadata) {
  std::string all = metadata.name + '\0';
  for (const auto& [key, value] : metadata.values)
    if (key != kCheckSum) all += key + '\0' + value + '\0';
  char text[12];
  std::snprintf(text, sizeof text, "%08x", mcap::crc32(all));
  return text;
}

mcap::Metadata as_metadata(const SessionInfo& info) {
  mcap::Metadata metadata{std::string(kSessionMetadata),
                          {{"program", info.program},
                           {"version", info.version},
                           {"commit", info.commit},
                           {"source", info.source},
                           {"scene", info.scene}}};
  if (!info.recorded_by.empty()) metadata.values["recorded_by"] = info.recorded_by;
  if (!info.consent.empty()) metadata.values["consent"] = info.consent;
  if (!info.voice_consent.empty()) metadata.values["voice_consent"] = info.voice_consent;
  metadata.values[kCheckSum] = check_sum_of(metadata);
  return metadata;
}

std::string value_or_empty(const mcap::TextMap& values, const char* key) {
  const auto place = values.find(key);
  return place == values.end() ? std::string{} : place->second;
}

}  // namespace

SessionInfo session_info(const mcap::Metadata& metadata) {
  const mcap::TextMap& values = metadata.values;
  return {.program = value_or_empty(values, "program"),
          .version = value_or_empty(values, "version"),
          .commit = value_or_empty(values, "commit"),
          .source = value_or_empty(values, "source"),
          .scene = value_or_empty(values, "scene"),
          .recorded_by = value_or_empty(values, "recorded_by"),
          .consent = value_or_empty(values, "consent"),
          .voice_consent = value_or_empty(values, "voice_consent")};
}

bool is_intact(const mcap::Metadata& metadata) {
  const std::string stated = value_or_empty(metadata.values, kCheckSum);
  return stated.empty() || stated == check_sum_of(metadata);
}

Result<McapWriter> McapWriter::open(const std::filesystem::path& name, const SessionInfo& info,
                                    mcap::ChunkLimits limits, mcap::Protection protection) {
  Result<mcap::OutputFile> file = mcap::OutputFile::create(name, protection);
  if (!file) return file.error();
  McapWriter writer(std::move(file).value(), limits);
  writer.encoder_.begin(writer.ready_, {.profile = "", .library = info.program + " " + info.version});
  writer.encoder_.add(writer.ready_, as_metadata(info));
  if (const Result<void> stored = writer.store(); !stored) return stored.error();
  return writer;
}

McapWriter::~McapWriter() {
  if (file_.is_open()) (void)close();
}

Result<void> McapWriter::store() {
  if (failed_) return *failed_;
  if (ready_.empty()) return {};
  const Result<void> appended = file_.append(ready_);
  ready_.clear();
  if (appended) {
    encoder_.commit();
    return {};
  }
  encoder_.rollback();
  failed_ = appended.error();
  return appended;
}

Result<void> McapWriter::write(const Message& message) {
  if (failed_) return *failed_;
  Known& known = topics_[message.topic.name];
  std::uint16_t& id = message.key_frame ? known.key_id : known.predicted_id;
  if (id == 0) {
    const mcap::Schema schema = mcap::schema_of(message.topic);
    id = add_channel(&schema, mcap::channel_for(message.topic, message.key_frame));
  }
  const std::uint64_t time = mcap::stored_time(message.published);
  ++known.messages;
  const auto sequence = message.sequence == 0 ? known.messages : static_cast<std::uint32_t>(message.sequence);
  encoder_.add(ready_, mcap::MessageRecord{id, sequence, time, time, *message.payload});
  return store();
}

/// The id of this channel in this file; writes schema and channel when they are new.
std::uint16_t McapWriter::add_channel(const mcap::Schema* schema, mcap::Channel channel) {
  channel.schema_id = 0;
  if (schema != nullptr) {
    std::uint16_t& schema_id = schemas_[identity(*schema)];
    if (schema_id == 0) schema_id = encoder_.add(ready_, *schema);
    channel.schema_id = schema_id;
  }
  std::uint16_t& id = channels_[identity(channel)];
  if (id == 0) id = encoder_.add(ready_, channel);
  return id;
}

Result<void> McapWriter::copy(const mcap::StoredMessage& message) {
  if (failed_) return *failed_;
  mcap::MessageRecord record = message.record;
  record.channel_id = add_channel(message.channel->schema, mcap::marked_channel(message));
  encoder_.add(ready_, record);
  return store();
}

Result<void> McapWriter::add(const mcap::Metadata& metadata) {
  if (failed_) return *failed_;
  encoder_.add(ready_, metadata);
  return store();
}

Result<void> McapWriter::add(const mcap::Attachment& attachment) {
  if (failed_) return *failed_;
  encoder_.add(ready_, attachment);
  return store();
}

Result<void> McapWriter::flush() {
  if (failed_) return *failed_;
  encoder_.flush(ready_);
  return store();
}

Result<void> McapWriter::close() {
  if (!file_.is_open()) return {};
  std::string last;
  if (!failed_) {
    if (const Result<void> flushed = flush(); !flushed) failed_ = flushed.error();
  }
  encoder_.end(last);
  if (const Result<void> appended = file_.append(last); !appended) {
    file_.leave();
    return failed_ ? *failed_ : appended.error();
  }
  final_bytes_ = encoder_.committed_bytes() + last.size();
  if (const Result<void> published = file_.publish(); !published) return published;
  if (failed_) return *failed_;
  return {};
}

Result<void> McapWriter::finish(Result<void> written) {
  if (written) written = flush();  // close() alone would complete the file after a failed write, too
  if (written) written = close();
  if (!written) discard();
  return written;
}

}  // namespace telepalp::wire
