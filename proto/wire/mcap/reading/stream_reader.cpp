#include "proto/wire/mcap/reading/stream_reader.h"

#include <utility>

namespace telepalp::wire {

using mcap::Opcode;
using mcap::RecordHead;
using mcap::StoredMessage;

Result<McapStreamReader> McapStreamReader::open(const std::filesystem::path& file) {
  Result<std::unique_ptr<mcap::ByteSource>> source = mcap::open_file(file);
  if (!source) return source.error();
  return open(std::move(source).value());
}

Result<McapStreamReader> McapStreamReader::open(std::unique_ptr<mcap::ByteSource> source) {
  if (const Result<void> magic = mcap::check_magic(*source); !magic) return magic.error();
  return McapStreamReader(std::move(source));
}

Error McapStreamReader::in_chunk(const Error& error) const { return mcap::in_chunk(*source_, chunks_ - 1, error); }

Error McapStreamReader::cut_off() const {
  std::string opcode;
  const bool in_a_chunk = source_->size() > offset_ && source_->read(offset_, 1, opcode) &&
                          static_cast<Opcode>(opcode.front()) == Opcode::Chunk;
  if (in_a_chunk) return mcap::in_chunk(*source_, chunks_, {.what = "truncated", .where = {}, .fix = {}});
  return mcap::damaged(*source_, "truncated after " + std::to_string(chunks_) + " chunks");
}

Result<void> McapStreamReader::enter_chunk(const RecordHead& head) {
  ++chunks_;
  if (const Result<void> read = mcap::read_content(*source_, head, content_); !read) return in_chunk(read.error());
  const auto chunk = mcap::parse<mcap::ChunkRecord>(content_);
  if (!chunk) return in_chunk({.what = "its header is damaged", .where = {}, .fix = {}});
  Result<std::string> records = mcap::unpack(*chunk);
  if (!records) return in_chunk(records.error());
  records_ = std::make_unique<const std::string>(std::move(records).value());
  walk_.emplace(*records_);
  return {};
}

/// Reads one record of the data section; true while more may follow.
Result<bool> McapStreamReader::enter_next_record() {
  const Result<RecordHead> head = mcap::read_head(*source_, offset_, source_->size());
  if (!head) {
    ended_ = true;
    return cut_off();
  }
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
    if (!schema || !channels_.add(*std::move(schema))) return mcap::damaged(*source_, "a schema is damaged");
  } else if (opcode == Opcode::Channel) {
    auto channel = mcap::parse<mcap::Channel>(content);
    if (!channel || !channels_.add(*std::move(channel))) return mcap::damaged(*source_, "a channel is damaged");
  } else if (opcode == Opcode::Metadata) {
    auto metadata = mcap::parse<mcap::Metadata>(content);
    if (!metadata) return mcap::damaged(*source_, "a metadata record is damaged");
    metadata_.push_back(*std::move(metadata));
  } else if (opcode == Opcode::Message) {
    const auto record = mcap::parse<mcap::MessageRecord>(content);
    const mcap::StoredChannel* const channel = record ? channels_.find(record->channel_id) : nullptr;
    if (channel == nullptr) return mcap::damaged(*source_, "a message is damaged, or its channel is not known");
    return std::optional{StoredMessage{channel, *record}};
  }
  return none;
}

Result<std::optional<StoredMessage>> McapStreamReader::next() {
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

Result<mcap::Attachment> McapStreamReader::read(const RecordHead& attachment) {
  std::string content;
  if (const Result<void> got = mcap::read_content(*source_, attachment, content); !got) return got.error();
  auto parsed = mcap::parse<mcap::Attachment>(content);
  if (!parsed) return mcap::damaged(*source_, "an attachment is damaged");
  return *std::move(parsed);
}

}  // namespace telepalp::wire
