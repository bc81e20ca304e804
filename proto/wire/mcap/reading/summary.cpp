#include "proto/wire/mcap/reading/summary.h"

#include <algorithm>

#include "proto/wire/mcap/format/byte_cursor.h"
#include "proto/wire/mcap/format/compression.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::uint64_t kFooterContentBytes = 20;
constexpr std::uint64_t kTailBytes = kRecordHeadBytes + kFooterContentBytes + kMagic.size();

struct Footing {
  Footer footer;
  std::uint64_t offset;  // file offset of the footer
};

Result<Footing> read_footer(ByteSource& source) {
  const Error no_summary = damaged(
      source, "has no summary at its end: the file is truncated, or was written without a summary", source.size());
  if (source.size() < kMagic.size() + kTailBytes) return no_summary;
  const std::uint64_t offset = source.size() - kTailBytes;
  std::string tail;
  if (!source.read(offset, kTailBytes, tail)) return unreadable(source, offset);
  if (!tail.ends_with(kMagic)) return no_summary;
  ByteCursor from(tail);
  if (from.u8() != static_cast<std::uint8_t>(Opcode::Footer) || from.u64() != kFooterContentBytes) return no_summary;
  const auto footer = parse<Footer>(from.rest());
  if (!footer || footer->summary_start == 0) return no_summary;
  if (footer->summary_start < kMagic.size() || footer->summary_start > offset)
    return damaged(source, "its footer states a place of the summary that lies outside the file", offset);
  return Footing{*footer, offset};
}

bool lies_within(std::uint64_t offset, std::uint64_t length, std::uint64_t end) {
  return offset >= kMagic.size() && offset <= end && length <= end - offset;
}

/// Adds one summary record; false if it is invalid.
bool take(Summary& summary, Opcode opcode, std::string_view content, std::uint64_t data_end) {
  switch (opcode) {
    case Opcode::Schema: {
      auto schema = parse<Schema>(content);
      return schema && summary.channels.add(*std::move(schema));
    }
    case Opcode::Channel: {
      auto channel = parse<Channel>(content);
      if (channel && !summary.channels.has_schema(channel->schema_id)) return true;  // its chunk defines both
      return channel && summary.channels.add(*std::move(channel));
    }
    case Opcode::Statistics: {
      auto statistics = parse<Statistics>(content);
      if (statistics) summary.statistics = *std::move(statistics);
      return statistics.has_value();
    }
    case Opcode::ChunkIndex: {
      auto index = parse<ChunkIndex>(content);
      if (!index || !lies_within(index->chunk_start_offset, index->chunk_length, data_end)) return false;
      if (index->chunk_length < kRecordHeadBytes || index->message_start_time > index->message_end_time) return false;
      summary.chunks.push_back(*std::move(index));
      return true;
    }
    case Opcode::AttachmentIndex: {
      auto index = parse<AttachmentIndex>(content);
      if (!index || !lies_within(index->offset, index->length, data_end)) return false;
      summary.attachments.push_back(*std::move(index));
      return true;
    }
    case Opcode::MetadataIndex: {
      auto index = parse<MetadataIndex>(content);
      if (!index || !lies_within(index->offset, index->length, data_end)) return false;
      summary.metadata.push_back(*std::move(index));
      return true;
    }
    default:
      return true;
  }
}

/// Reads bytes [start, start + length) part by part, so that a reader of a slow disk sees it go on. False: unreadable.
bool read_in_parts(ByteSource& source, std::uint64_t start, std::uint64_t length, std::string& into,
                   const Progress& progress) {
  constexpr std::uint64_t kPart = std::uint64_t{1} << 20;
  std::string part;
  into.reserve(length);
  while (into.size() < length) {
    if (!source.read(start + into.size(), std::min(kPart, length - into.size()), part)) return false;
    into += part;
    if (progress) progress(static_cast<double>(into.size()) / static_cast<double>(length));
  }
  return true;
}

}  // namespace

Result<Summary> read_summary(ByteSource& source, const Progress& progress) {
  if (const Result<void> magic = check_magic(source); !magic) return magic.error();
  const Result<Footing> footing = read_footer(source);
  if (!footing) return footing.error();
  const std::uint64_t start = footing->footer.summary_start;
  const std::uint64_t length = footing->offset - start;
  if (length > kMaxChunkBytes)
    return refused(source, "its summary is larger than 64 MiB",
                   "record in shorter files: telepalp-record --split SIZE");

  std::string bytes;  // the summary and the footer's part that the CRC covers
  const std::uint64_t covered = length + kRecordHeadBytes + kFooterContentBytes - sizeof(std::uint32_t);
  if (!read_in_parts(source, start, covered, bytes, progress)) return unreadable(source, start);
  if (footing->footer.summary_crc != 0 && footing->footer.summary_crc != crc32(bytes))
    return damaged(source, "the CRC of its summary does not match", start);

  Summary summary;
  summary.start = start;
  summary.has_crc = footing->footer.summary_crc != 0;
  bool counted = false, described = false;  // the number of messages is known; there are schemas or channels
  ByteCursor from(std::string_view(bytes).substr(0, length));
  while (from.ok() && !from.at_end()) {
    const std::uint64_t offset = start + length - from.rest().size();
    const auto opcode = static_cast<Opcode>(from.u8());
    const std::string_view content = from.raw(from.u64());
    if (!from.ok() || !take(summary, opcode, content, start)) return damaged(source, "its summary is damaged", offset);
    counted = counted || opcode == Opcode::Statistics;
    described = described || opcode == Opcode::Schema || opcode == Opcode::Channel;
  }
  if (summary.chunks.empty() && (counted ? summary.statistics.message_count > 0 : described))
    return damaged(source, "has no index of its messages", start);
  std::sort(summary.chunks.begin(), summary.chunks.end(),
            [](const ChunkIndex& a, const ChunkIndex& b) { return a.chunk_start_offset < b.chunk_start_offset; });
  return summary;
}

}  // namespace telepalp::wire::mcap
