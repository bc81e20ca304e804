#include "proto/wire/mcap/reading/stream_reader.h"

#include <algorithm>
#include <utility>

#include "proto/wire/mcap/format/compression.h"
#include "proto/wire/mcap/reading/chunk_search.h"
#include "proto/wire/mcap/reading/summary.h"
#include "proto/words/counted.h"

namespace telepalp::wire {

using mcap::Opcode;
using mcap::RecordHead;
using mcap::StoredMessage;

namespace {

/// False for the opcode 0, which the specification reserves, and for end-of-data records of a wrong length: a damaged
/// head would otherwise hide the rest of the file.
bool is_plausible(const RecordHead& head) noexcept {
  constexpr std::uint64_t kDataEndBytes = 4;
  constexpr std::uint64_t kFooterBytes = 20;
  if (head.opcode == Opcode::DataEnd) return head.length >= kDataEndBytes && head.length < 2 * kFooterBytes;
  if (head.opcode == Opcode::Footer) return head.length >= kFooterBytes && head.length < 2 * kFooterBytes;
  return head.opcode != Opcode{0};
}

}  // namespace

Result<McapStreamReader> McapStreamReader::open(std::unique_ptr<mcap::ByteSource> source) {
  if (const Result<void> magic = mcap::check_magic(*source); !magic) return magic.error();
  return McapStreamReader(std::move(source));
}

Error McapStreamReader::in_chunk(const Error& error) const {
  return mcap::in_chunk(*source_, chunks_ - 1, chunk_offset_, error);
}

Error McapStreamReader::error_at_end() const {
  std::string opcode;
  const bool in_a_chunk = source_->size() > offset_ && source_->read(offset_, 1, opcode) &&
                          static_cast<Opcode>(opcode.front()) == Opcode::Chunk;
  if (in_a_chunk) return mcap::in_chunk(*source_, chunks_, offset_, {.what = "truncated", .where = {}, .fix = {}});
  return mcap::damaged(*source_, "truncated after " + counted(chunks_, "chunk", "chunks"), offset_);
}

/// Continues after a place without a valid record at the next chunk, if there is one.
Error McapStreamReader::skip_to_next_chunk() {
  const std::optional<std::uint64_t> found = mcap::find_chunk(*source_, trusted_end_);
  ended_ = !found;
  cut_off_ = !found && mcap::ends_within_record(*source_, offset_);
  if (!found) return error_at_end();
  const Error skipped = mcap::damaged(
      *source_,
      "damaged bytes are skipped, and reading continues at byte " + std::to_string(*found) + "; the damage begins",
      offset_);
  offset_ = *found;
  trusted_end_ = *found + 1;  // the next search begins behind this chunk, so that reading always ends
  return skipped;
}

/// A complete file repeats all definitions in its summary, under a CRC of its own: with them, messages stay readable
/// where a definition in the data section is damaged or skipped.
void McapStreamReader::learn_channels_from_summary() {
  if (std::exchange(summary_read_, true)) return;
  const Result<mcap::Summary> summary = mcap::read_summary(*source_);
  if (!summary) return;
  summary_start_ = summary->start;
  summary_has_crc_ = summary->has_crc;
  for (const auto& [id, stored] : summary->channels.all()) {
    if (stored.schema != nullptr) (void)channels_.add(*stored.schema);  // false: contradicts a definition before
    (void)channels_.add(stored.channel);
  }
}

Result<void> McapStreamReader::enter_chunk(const RecordHead& head) {
  ++chunks_;
  chunk_offset_ = head.offset;
  if (const Result<void> read = mcap::read_content(*source_, head, content_); !read) return in_chunk(read.error());
  const auto chunk = mcap::parse<mcap::ChunkRecord>(content_);
  if (!chunk) return in_chunk({.what = "its header is damaged", .where = {}, .fix = {}});
  // The chunk's own sizes, because a damaged length in the head may reach over the chunks behind.
  trusted_end_ = head.content() + static_cast<std::uint64_t>(chunk->records.end() - std::string_view(content_).begin());
  Result<std::string> records = mcap::unpack(*chunk);
  if (!records) return in_chunk(records.error());
  records_ = std::make_unique<const std::string>(std::move(records).value());
  walk_.emplace(*records_);
  return {};
}

/// Reads one record of the data section; true while more may follow.
Result<bool> McapStreamReader::enter_next_record() {
  const Result<RecordHead> head = mcap::read_head(*source_, offset_, source_->size());
  if (!head || !is_plausible(*head)) return skip_to_next_chunk();
  record_offset_ = offset_;
  offset_ = head->end();
  switch (head->opcode) {
    case Opcode::Chunk:
      if (const Result<void> entered = enter_chunk(*head); !entered) return entered.error();
      return true;
    case Opcode::Schema:
    case Opcode::Channel:
    case Opcode::Message:
    case Opcode::Metadata:
      if (const Result<void> read = mcap::read_content(*source_, *head, content_); !read) return read.error();
      waiting_ = head->opcode;
      return true;
    case Opcode::Attachment:
      attachments_.push_back(*head);
      return true;
    case Opcode::DataEnd:
    case Opcode::Footer:
      data_end_ = *head;
      ended_ = true;
      complete_ = true;
      return false;
    default:
      return true;  // header, indexes and records of later versions of the specification are skipped
  }
}

Result<std::optional<StoredMessage>> McapStreamReader::take(Opcode opcode, std::string_view content) {
  std::optional<StoredMessage> none;
  if (opcode == Opcode::Schema) {
    auto schema = mcap::parse<mcap::Schema>(content);
    if (!schema || !channels_.add(*std::move(schema)))
      return mcap::damaged(*source_, "a schema is damaged", record_offset_);
  } else if (opcode == Opcode::Channel) {
    auto channel = mcap::parse<mcap::Channel>(content);
    if (!channel || !channels_.add(*std::move(channel)))
      return mcap::damaged(*source_, "a channel is damaged", record_offset_);
  } else if (opcode == Opcode::Metadata) {
    auto metadata = mcap::parse<mcap::Metadata>(content);
    if (!metadata) return mcap::damaged(*source_, "a metadata record is damaged", record_offset_);
    metadata_.push_back(*std::move(metadata));
  } else if (opcode == Opcode::Message) {
    const auto record = mcap::parse<mcap::MessageRecord>(content);
    const mcap::StoredChannel* const channel = record ? channels_.find(record->channel_id) : nullptr;
    if (channel == nullptr)
      return mcap::damaged(*source_, "a message is damaged, or the file does not define its channel", record_offset_);
    return std::optional{StoredMessage{channel, *record}};
  }
  return none;
}

Result<std::optional<StoredMessage>> McapStreamReader::next() {
  learn_channels_from_summary();
  while (!ended_ || walk_) {
    if (waiting_) {
      const Opcode opcode = *std::exchange(waiting_, std::nullopt);
      auto taken = take(opcode, content_);
      if (!taken || *taken) return taken;
    }
    if (walk_) {
      const auto entry = walk_->next();
      if (!entry || !*entry) walk_.reset();
      if (!entry) return in_chunk(entry.error());
      if (!*entry) continue;
      auto taken = take((*entry)->opcode, (*entry)->content);
      if (!taken) return in_chunk({.what = taken.error().what, .where = {}, .fix = {}});
      if (*taken) return taken;
      continue;
    }
    const Result<bool> more = enter_next_record();
    if (!more) return more.error();
  }
  return std::optional<StoredMessage>{};
}

Result<void> McapStreamReader::check_bytes(bool has_crcs) {
  if (!data_end_) return {};
  const std::uint64_t end = data_end_->offset;
  if (data_end_->opcode != Opcode::DataEnd || (summary_start_ && *summary_start_ != data_end_->end()))
    return mcap::damaged(*source_, "the record at the end of its data is damaged", end);
  if (const Result<void> read = mcap::read_content(*source_, *data_end_, content_); !read) return read.error();
  const auto wanted = mcap::parse<mcap::DataEnd>(content_);
  if (!wanted) return mcap::damaged(*source_, "the record at the end of its data is damaged", end);
  if (has_crcs && (wanted->data_section_crc == 0 || !summary_has_crc_))
    return mcap::damaged(*source_, "the CRC of its data or of its summary is missing", end);
  if (wanted->data_section_crc == 0) return {};
  constexpr std::uint64_t kBlockBytes = 1 << 20;
  std::uint32_t crc = 0;
  std::string block;
  for (std::uint64_t at = 0; at < end; at += block.size()) {
    if (!source_->read(at, std::min(end - at, kBlockBytes), block)) return mcap::unreadable(*source_, at);
    crc = mcap::crc32(block, crc);
  }
  if (crc == wanted->data_section_crc) return {};
  return mcap::damaged(*source_, "the CRC of all its data does not match: a byte outside its messages has changed");
}

Result<mcap::Attachment> McapStreamReader::read(const RecordHead& attachment) {
  std::string content;
  if (const Result<void> got = mcap::read_content(*source_, attachment, content); !got) return got.error();
  auto parsed = mcap::parse<mcap::Attachment>(content);
  if (!parsed) return mcap::damaged(*source_, "an attachment is damaged", attachment.offset);
  return *std::move(parsed);
}

}  // namespace telepalp::wire
