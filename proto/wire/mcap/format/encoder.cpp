#include "proto/wire/mcap/format/encoder.h"

#include <algorithm>
#include <utility>

#include "proto/wire/mcap/format/compression.h"
#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::wire::mcap {
namespace {

constexpr std::string_view kZstd = "zstd";

/// Appends each of `records` and an offset record with the position of the group; an empty group has none.
template <class Record>
void append_group(std::string& out, std::uint64_t out_offset, Opcode opcode, const std::vector<Record>& records,
                  std::vector<SummaryOffset>& offsets) {
  if (records.empty()) return;
  const std::size_t start = out.size();
  for (const Record& record : records) append(out, record);
  offsets.push_back({opcode, out_offset + start, out.size() - start});
}

}  // namespace

void Encoder::written(std::string_view bytes) {
  now_.bytes += bytes.size();
  now_.data_crc = crc32(bytes, now_.data_crc);
}

void Encoder::begin(std::string& out, const Header& header) {
  const std::size_t start = out.size();
  out += kMagic;
  append(out, header);
  written(std::string_view(out).substr(start));
}

std::uint16_t Encoder::add(std::string& out, Schema schema) {
  demand(schemas_.size() < UINT16_MAX, "a file has at most 65535 schemas");
  schema.id = static_cast<std::uint16_t>(schemas_.size() + 1);
  const std::size_t start = out.size();
  append(out, schema);
  written(std::string_view(out).substr(start));
  schemas_.push_back(std::move(schema));
  return schemas_.back().id;
}

std::uint16_t Encoder::add(std::string& out, Channel channel) {
  demand(channels_.size() < UINT16_MAX, "a file has at most 65535 channels");
  channel.id = static_cast<std::uint16_t>(channels_.size() + 1);
  const std::size_t start = out.size();
  append(out, channel);
  written(std::string_view(out).substr(start));
  channels_.push_back(std::move(channel));
  return channels_.back().id;
}

void Encoder::add(std::string& out, const MessageRecord& message) {
  demand(message.channel_id >= 1 && message.channel_id <= channels_.size(),
         "a message is written after the channel that it names");
  MessageIndex& index = open_.indexes[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.push_back({message.log_time, open_.records.size()});
  open_.start = std::min(open_.start, message.log_time);
  open_.end = std::max(open_.end, message.log_time);
  append(open_.records, message);
  // The time span is measured per channel. Otherwise two senders with different clocks would close the chunk at every
  // message.
  const std::uint64_t first = index.entries.front().log_time;
  const bool long_enough = message.log_time >= first && message.log_time - first >= limits_.span_ns;
  if (open_.records.size() >= limits_.bytes || long_enough) flush(out);
}

void Encoder::add(std::string& out, const Metadata& metadata) {
  const std::size_t start = out.size();
  const std::size_t length = append(out, metadata);
  metadata_indexes_.push_back({now_.bytes, length, metadata.name});
  written(std::string_view(out).substr(start));
}

void Encoder::add(std::string& out, const Attachment& attachment) {
  const std::size_t start = out.size();
  const std::size_t length = append(out, attachment);
  attachment_indexes_.push_back({now_.bytes, length, attachment.log_time, attachment.create_time,
                                 attachment.data.size(), attachment.name, attachment.media_type});
  written(std::string_view(out).substr(start));
}

void Encoder::count(const OpenChunk& chunk) {
  Statistics& total = now_.statistics;
  total.message_start_time = total.message_count == 0 ? chunk.start : std::min(total.message_start_time, chunk.start);
  total.message_end_time = std::max(total.message_end_time, chunk.end);
  for (const auto& [channel, index] : chunk.indexes) {
    total.message_count += index.entries.size();
    total.channel_message_counts[channel] += index.entries.size();
  }
}

void Encoder::flush(std::string& out) {
  if (open_.indexes.empty()) return;
  const OpenChunk chunk = std::exchange(open_, {});
  const std::string packed = zstd_compress(chunk.records);
  ChunkIndex index{.message_start_time = chunk.start,
                   .message_end_time = chunk.end,
                   .chunk_start_offset = now_.bytes,
                   .chunk_length = 0,
                   .message_index_offsets = {},
                   .message_index_length = 0,
                   .compression = std::string(kZstd),
                   .compressed_size = packed.size(),
                   .uncompressed_size = chunk.records.size()};
  const std::size_t start = out.size();
  index.chunk_length =
      append(out, ChunkRecord{chunk.start, chunk.end, chunk.records.size(), crc32(chunk.records), kZstd, packed});
  for (const auto& [channel, messages] : chunk.indexes) {
    index.message_index_offsets[channel] = now_.bytes + (out.size() - start);
    index.message_index_length += append(out, messages);
  }
  written(std::string_view(out).substr(start));
  chunk_indexes_.push_back(std::move(index));
  count(chunk);
}

void Encoder::end(std::string& out) {
  flush(out);
  append(out, DataEnd{now_.data_crc});
  // An offset in the file is the offset in `out` plus the number of committed bytes.
  const std::uint64_t out_offset = committed_.bytes;
  Statistics statistics = now_.statistics;
  statistics.schema_count = static_cast<std::uint16_t>(schemas_.size());
  statistics.channel_count = static_cast<std::uint32_t>(channels_.size());
  statistics.attachment_count = static_cast<std::uint32_t>(attachment_indexes_.size());
  statistics.metadata_count = static_cast<std::uint32_t>(metadata_indexes_.size());
  statistics.chunk_count = static_cast<std::uint32_t>(chunk_indexes_.size());

  const std::size_t summary = out.size();
  std::vector<SummaryOffset> offsets;
  append_group(out, out_offset, Opcode::Schema, schemas_, offsets);
  append_group(out, out_offset, Opcode::Channel, channels_, offsets);
  append_group(out, out_offset, Opcode::Statistics, std::vector{statistics}, offsets);
  append_group(out, out_offset, Opcode::ChunkIndex, chunk_indexes_, offsets);
  append_group(out, out_offset, Opcode::AttachmentIndex, attachment_indexes_, offsets);
  append_group(out, out_offset, Opcode::MetadataIndex, metadata_indexes_, offsets);
  const std::size_t summary_offsets = out.size();
  for (const SummaryOffset& offset : offsets) append(out, offset);

  // The CRC covers the summary and the footer's bytes before the CRC.
  append(out, Footer{out_offset + summary, out_offset + summary_offsets, 0});
  const std::size_t crc_at = out.size() - sizeof(std::uint32_t);
  const std::uint32_t crc = crc32(std::string_view(out).substr(summary, crc_at - summary));
  put_little_endian<std::uint32_t>(out.data() + crc_at, crc);
  out += kMagic;
}

void Encoder::commit() {
  now_.chunks = chunk_indexes_.size();
  now_.attachments = attachment_indexes_.size();
  now_.metadata = metadata_indexes_.size();
  committed_ = now_;
}

void Encoder::rollback() {
  open_ = {};
  now_ = committed_;
  chunk_indexes_.resize(now_.chunks);
  attachment_indexes_.resize(now_.attachments);
  metadata_indexes_.resize(now_.metadata);
}

}  // namespace telepalp::wire::mcap
