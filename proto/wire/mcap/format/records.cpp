#include "proto/wire/mcap/format/records.h"

#include "proto/wire/mcap/format/byte_cursor.h"
#include "proto/wire/mcap/format/compression.h"
#include "proto/words/formats.h"
#include "proto/words/little_endian.h"

namespace telepalp::wire::mcap {

static_assert(kMagic[5] == '0' + kMcapVersion);

namespace {

/// Writes head and content; the length is set after the content is written.
template <class Write>
std::size_t append_record(std::string& out, Opcode opcode, Write write) {
  const std::size_t start = out.size();
  ByteAppender to(out);
  to.u8(static_cast<std::uint8_t>(opcode));
  to.u64(0);
  write(to);
  const std::uint64_t length = out.size() - start - kRecordHeadBytes;
  put_little_endian<std::uint64_t>(out.data() + start + 1, length);
  return out.size() - start;
}

void append_map(ByteAppender& to, const TextMap& map) {
  std::string entries;
  ByteAppender entry(entries);
  for (const auto& [key, value] : map) {
    entry.text(key);
    entry.text(value);
  }
  to.text(entries);
}

void append_map(ByteAppender& to, const std::map<std::uint16_t, std::uint64_t>& map) {
  to.u32(static_cast<std::uint32_t>(map.size() * 10));
  for (const auto& [key, value] : map) {
    to.u16(key);
    to.u64(value);
  }
}

TextMap read_text_map(ByteCursor& from) {
  TextMap map;
  ByteCursor entries(from.text());
  while (entries.ok() && !entries.at_end()) {
    std::string key{entries.text()};
    map[std::move(key)] = entries.text();
  }
  if (!entries.ok()) from.raw(UINT64_MAX);  // an invalid map makes the whole record invalid
  return map;
}

std::map<std::uint16_t, std::uint64_t> read_count_map(ByteCursor& from) {
  std::map<std::uint16_t, std::uint64_t> map;
  ByteCursor entries(from.text());
  while (entries.ok() && !entries.at_end()) {
    const std::uint16_t key = entries.u16();
    map[key] = entries.u64();
  }
  if (!entries.ok()) from.raw(UINT64_MAX);
  return map;
}

template <class Record>
std::optional<Record> if_whole(const ByteCursor& from, Record record) {
  if (!from.ok()) return std::nullopt;
  return record;
}

}  // namespace

std::size_t append(std::string& out, const Header& header) {
  return append_record(out, Opcode::Header, [&](ByteAppender to) {
    to.text(header.profile);
    to.text(header.library);
  });
}
template <>
std::optional<Header> parse(std::string_view content) {
  ByteCursor from(content);
  Header header;
  header.profile = from.text();
  header.library = from.text();
  return if_whole(from, header);
}

std::size_t append(std::string& out, const Footer& footer) {
  return append_record(out, Opcode::Footer, [&](ByteAppender to) {
    to.u64(footer.summary_start);
    to.u64(footer.summary_offset_start);
    to.u32(footer.summary_crc);
  });
}
template <>
std::optional<Footer> parse(std::string_view content) {
  ByteCursor from(content);
  Footer footer;
  footer.summary_start = from.u64();
  footer.summary_offset_start = from.u64();
  footer.summary_crc = from.u32();
  return if_whole(from, footer);
}

std::size_t append(std::string& out, const Schema& schema) {
  return append_record(out, Opcode::Schema, [&](ByteAppender to) {
    to.u16(schema.id);
    to.text(schema.name);
    to.text(schema.encoding);
    to.text(schema.data);
  });
}
template <>
std::optional<Schema> parse(std::string_view content) {
  ByteCursor from(content);
  Schema schema;
  schema.id = from.u16();
  schema.name = from.text();
  schema.encoding = from.text();
  schema.data = from.text();
  return if_whole(from, std::move(schema));
}

std::size_t append(std::string& out, const Channel& channel) {
  return append_record(out, Opcode::Channel, [&](ByteAppender to) {
    to.u16(channel.id);
    to.u16(channel.schema_id);
    to.text(channel.topic);
    to.text(channel.message_encoding);
    append_map(to, channel.metadata);
  });
}
template <>
std::optional<Channel> parse(std::string_view content) {
  ByteCursor from(content);
  Channel channel;
  channel.id = from.u16();
  channel.schema_id = from.u16();
  channel.topic = from.text();
  channel.message_encoding = from.text();
  channel.metadata = read_text_map(from);
  return if_whole(from, std::move(channel));
}

std::size_t append(std::string& out, const MessageRecord& message) {
  return append_record(out, Opcode::Message, [&](ByteAppender to) {
    to.u16(message.channel_id);
    to.u32(message.sequence);
    to.u64(message.log_time);
    to.u64(message.publish_time);
    to.raw(message.data);
  });
}
template <>
std::optional<MessageRecord> parse(std::string_view content) {
  ByteCursor from(content);
  MessageRecord message;
  message.channel_id = from.u16();
  message.sequence = from.u32();
  message.log_time = from.u64();
  message.publish_time = from.u64();
  message.data = from.rest();
  return if_whole(from, message);
}

std::size_t append(std::string& out, const ChunkRecord& chunk) {
  return append_record(out, Opcode::Chunk, [&](ByteAppender to) {
    to.u64(chunk.message_start_time);
    to.u64(chunk.message_end_time);
    to.u64(chunk.uncompressed_size);
    to.u32(chunk.uncompressed_crc);
    to.text(chunk.compression);
    to.u64(chunk.records.size());
    to.raw(chunk.records);
  });
}
template <>
std::optional<ChunkRecord> parse(std::string_view content) {
  ByteCursor from(content);
  ChunkRecord chunk;
  chunk.message_start_time = from.u64();
  chunk.message_end_time = from.u64();
  chunk.uncompressed_size = from.u64();
  chunk.uncompressed_crc = from.u32();
  chunk.compression = from.text();
  chunk.records = from.raw(from.u64());
  return if_whole(from, chunk);
}

std::size_t append(std::string& out, const MessageIndex& index) {
  return append_record(out, Opcode::MessageIndex, [&](ByteAppender to) {
    to.u16(index.channel_id);
    to.u32(static_cast<std::uint32_t>(index.entries.size() * 16));
    for (const MessageIndex::Entry& entry : index.entries) {
      to.u64(entry.log_time);
      to.u64(entry.offset);
    }
  });
}
template <>
std::optional<MessageIndex> parse(std::string_view content) {
  ByteCursor from(content);
  MessageIndex index;
  index.channel_id = from.u16();
  ByteCursor entries(from.text());
  while (entries.ok() && !entries.at_end()) {
    const std::uint64_t log_time = entries.u64();
    index.entries.push_back({log_time, entries.u64()});
  }
  if (!entries.ok()) return std::nullopt;
  return if_whole(from, std::move(index));
}

std::size_t append(std::string& out, const ChunkIndex& index) {
  return append_record(out, Opcode::ChunkIndex, [&](ByteAppender to) {
    to.u64(index.message_start_time);
    to.u64(index.message_end_time);
    to.u64(index.chunk_start_offset);
    to.u64(index.chunk_length);
    append_map(to, index.message_index_offsets);
    to.u64(index.message_index_length);
    to.text(index.compression);
    to.u64(index.compressed_size);
    to.u64(index.uncompressed_size);
  });
}
template <>
std::optional<ChunkIndex> parse(std::string_view content) {
  ByteCursor from(content);
  ChunkIndex index;
  index.message_start_time = from.u64();
  index.message_end_time = from.u64();
  index.chunk_start_offset = from.u64();
  index.chunk_length = from.u64();
  index.message_index_offsets = read_count_map(from);
  index.message_index_length = from.u64();
  index.compression = from.text();
  index.compressed_size = from.u64();
  index.uncompressed_size = from.u64();
  return if_whole(from, std::move(index));
}

std::size_t append(std::string& out, const Attachment& attachment) {
  return append_record(out, Opcode::Attachment, [&](ByteAppender to) {
    const std::size_t content = out.size();
    to.u64(attachment.log_time);
    to.u64(attachment.create_time);
    to.text(attachment.name);
    to.text(attachment.media_type);
    to.u64(attachment.data.size());
    to.raw(attachment.data);
    to.u32(crc32(std::string_view(out).substr(content)));
  });
}
template <>
std::optional<Attachment> parse(std::string_view content) {
  ByteCursor from(content);
  Attachment attachment;
  attachment.log_time = from.u64();
  attachment.create_time = from.u64();
  attachment.name = from.text();
  attachment.media_type = from.text();
  attachment.data = from.raw(from.u64());
  const std::size_t covered = content.size() - from.rest().size();
  const std::uint32_t crc = from.u32();
  if (from.ok() && crc != 0 && crc != crc32(content.substr(0, covered))) return std::nullopt;
  return if_whole(from, std::move(attachment));
}

std::size_t append(std::string& out, const AttachmentIndex& index) {
  return append_record(out, Opcode::AttachmentIndex, [&](ByteAppender to) {
    to.u64(index.offset);
    to.u64(index.length);
    to.u64(index.log_time);
    to.u64(index.create_time);
    to.u64(index.data_size);
    to.text(index.name);
    to.text(index.media_type);
  });
}
template <>
std::optional<AttachmentIndex> parse(std::string_view content) {
  ByteCursor from(content);
  AttachmentIndex index;
  index.offset = from.u64();
  index.length = from.u64();
  index.log_time = from.u64();
  index.create_time = from.u64();
  index.data_size = from.u64();
  index.name = from.text();
  index.media_type = from.text();
  return if_whole(from, std::move(index));
}

std::size_t append(std::string& out, const Statistics& statistics) {
  return append_record(out, Opcode::Statistics, [&](ByteAppender to) {
    to.u64(statistics.message_count);
    to.u16(statistics.schema_count);
    to.u32(statistics.channel_count);
    to.u32(statistics.attachment_count);
    to.u32(statistics.metadata_count);
    to.u32(statistics.chunk_count);
    to.u64(statistics.message_start_time);
    to.u64(statistics.message_end_time);
    append_map(to, statistics.channel_message_counts);
  });
}
template <>
std::optional<Statistics> parse(std::string_view content) {
  ByteCursor from(content);
  Statistics statistics;
  statistics.message_count = from.u64();
  statistics.schema_count = from.u16();
  statistics.channel_count = from.u32();
  statistics.attachment_count = from.u32();
  statistics.metadata_count = from.u32();
  statistics.chunk_count = from.u32();
  statistics.message_start_time = from.u64();
  statistics.message_end_time = from.u64();
  statistics.channel_message_counts = read_count_map(from);
  return if_whole(from, std::move(statistics));
}

std::size_t append(std::string& out, const Metadata& metadata) {
  return append_record(out, Opcode::Metadata, [&](ByteAppender to) {
    to.text(metadata.name);
    append_map(to, metadata.values);
  });
}
template <>
std::optional<Metadata> parse(std::string_view content) {
  ByteCursor from(content);
  Metadata metadata;
  metadata.name = from.text();
  metadata.values = read_text_map(from);
  return if_whole(from, std::move(metadata));
}

std::size_t append(std::string& out, const MetadataIndex& index) {
  return append_record(out, Opcode::MetadataIndex, [&](ByteAppender to) {
    to.u64(index.offset);
    to.u64(index.length);
    to.text(index.name);
  });
}
template <>
std::optional<MetadataIndex> parse(std::string_view content) {
  ByteCursor from(content);
  MetadataIndex index;
  index.offset = from.u64();
  index.length = from.u64();
  index.name = from.text();
  return if_whole(from, std::move(index));
}

std::size_t append(std::string& out, const SummaryOffset& offset) {
  return append_record(out, Opcode::SummaryOffset, [&](ByteAppender to) {
    to.u8(static_cast<std::uint8_t>(offset.group));
    to.u64(offset.group_start);
    to.u64(offset.group_length);
  });
}
template <>
std::optional<SummaryOffset> parse(std::string_view content) {
  ByteCursor from(content);
  SummaryOffset offset;
  offset.group = static_cast<Opcode>(from.u8());
  offset.group_start = from.u64();
  offset.group_length = from.u64();
  return if_whole(from, offset);
}

std::size_t append(std::string& out, const DataEnd& end) {
  return append_record(out, Opcode::DataEnd, [&](ByteAppender to) { to.u32(end.data_section_crc); });
}
template <>
std::optional<DataEnd> parse(std::string_view content) {
  ByteCursor from(content);
  DataEnd end;
  end.data_section_crc = from.u32();
  return if_whole(from, end);
}

}  // namespace telepalp::wire::mcap
