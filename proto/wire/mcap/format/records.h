#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The records of an MCAP file as plain values, with encoder and parser. Field names and order follow the MCAP
/// specification, version 0 ("Records"); times are in nanoseconds. A string_view in a parsed record points into the
/// parsed bytes.
namespace telepalp::wire::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
inline constexpr std::size_t kRecordHeadBytes = 9;  // opcode u8, length u64

enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Attachment = 0x09,
  AttachmentIndex = 0x0A,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

using TextMap = std::map<std::string, std::string>;

struct Header {
  std::string profile;
  std::string library;
};
struct Footer {
  std::uint64_t summary_start = 0;         // 0: no summary
  std::uint64_t summary_offset_start = 0;  // 0: no summary offsets
  std::uint32_t summary_crc = 0;           // 0: not computed
};
struct Schema {
  std::uint16_t id = 0;  // never 0 in a file
  std::string name;
  std::string encoding;
  std::string data;
};
struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  // 0: no schema
  std::string topic;
  std::string message_encoding;
  TextMap metadata;
};
struct MessageRecord {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string_view data;
};
struct ChunkRecord {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  // 0: not computed
  std::string_view compression;        // "", "zstd", "lz4"
  std::string_view records;            // compressed
};
struct MessageIndex {
  struct Entry {
    std::uint64_t log_time = 0;
    std::uint64_t offset = 0;  // offset of the message record in the uncompressed chunk
  };
  std::uint16_t channel_id = 0;
  std::vector<Entry> entries;
};
struct ChunkIndex {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t chunk_start_offset = 0;
  std::uint64_t chunk_length = 0;  // includes the 9-byte record head
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};
struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  std::string data;
};
struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};
struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};
struct Metadata {
  std::string name;
  TextMap values;
};
struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};
struct SummaryOffset {
  Opcode group{};
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
};
struct DataEnd {
  std::uint32_t data_section_crc = 0;  // 0: not computed
};

/// Appends the record with its head and returns the number of bytes.
std::size_t append(std::string& out, const Header& header);
std::size_t append(std::string& out, const Footer& footer);
std::size_t append(std::string& out, const Schema& schema);
std::size_t append(std::string& out, const Channel& channel);
std::size_t append(std::string& out, const MessageRecord& message);
std::size_t append(std::string& out, const ChunkRecord& chunk);
std::size_t append(std::string& out, const MessageIndex& index);
std::size_t append(std::string& out, const ChunkIndex& index);
std::size_t append(std::string& out, const Attachment& attachment);
std::size_t append(std::string& out, const AttachmentIndex& index);
std::size_t append(std::string& out, const Statistics& statistics);
std::size_t append(std::string& out, const Metadata& metadata);
std::size_t append(std::string& out, const MetadataIndex& index);
std::size_t append(std::string& out, const SummaryOffset& offset);
std::size_t append(std::string& out, const DataEnd& end);

/// Parses a record's content (without its head); nullopt if it is malformed. Bytes after the known fields are skipped,
/// as the specification requires. Allocates at most in proportion to the size of `content`, whatever sizes it declares.
template <class Record>
[[nodiscard]] std::optional<Record> parse(std::string_view content);
template <>
std::optional<Header> parse(std::string_view content);
template <>
std::optional<Footer> parse(std::string_view content);
template <>
std::optional<Schema> parse(std::string_view content);
template <>
std::optional<Channel> parse(std::string_view content);
template <>
std::optional<MessageRecord> parse(std::string_view content);
template <>
std::optional<ChunkRecord> parse(std::string_view content);
template <>
std::optional<MessageIndex> parse(std::string_view content);
template <>
std::optional<ChunkIndex> parse(std::string_view content);
template <>
std::optional<Attachment> parse(std::string_view content);  // nullopt also for a wrong CRC
template <>
std::optional<AttachmentIndex> parse(std::string_view content);
template <>
std::optional<Statistics> parse(std::string_view content);
template <>
std::optional<Metadata> parse(std::string_view content);
template <>
std::optional<MetadataIndex> parse(std::string_view content);
template <>
std::optional<SummaryOffset> parse(std::string_view content);
template <>
std::optional<DataEnd> parse(std::string_view content);

}  // namespace telepalp::wire::mcap
