#include "proto/wire/mcap/reader.h"

#include <algorithm>

#include "proto/wire/mcap/format/chunk.h"
#include "proto/wire/mcap/format/stored_time.h"

namespace telepalp::wire {

using mcap::ChunkIndex;
using mcap::MessageRecord;
using mcap::StoredMessage;

namespace {

/// Chunks that overlap in time are in memory together. A file whose overlapping chunks exceed this size is refused.
constexpr std::uint64_t kMaxOpenBytes = 4 * mcap::kMaxChunkBytes;

bool matches(const std::string& pattern, const std::string& topic) {
  if (!pattern.empty() && pattern.back() == '*') return topic.starts_with(pattern.substr(0, pattern.size() - 1));
  return pattern == topic;
}

bool matches_any(const std::vector<std::string>& patterns, const std::string& topic) {
  return patterns.empty() ||
         std::any_of(patterns.begin(), patterns.end(), [&](const auto& pattern) { return matches(pattern, topic); });
}

}  // namespace

Result<McapReader> McapReader::open(const std::filesystem::path& file, const mcap::Progress& progress) {
  Result<std::unique_ptr<mcap::ByteSource>> source = mcap::open_session(file);
  if (!source) return source.error();
  return open(std::move(source).value(), progress);
}

Result<McapReader> McapReader::open(std::unique_ptr<mcap::ByteSource> source, const mcap::Progress& progress) {
  McapReader reader(std::move(source));
  Result<mcap::Summary> summary = mcap::read_summary(*reader.source_, progress);
  if (!summary) return summary.error();
  reader.summary_ = std::move(summary).value();
  reader.select({});
  return reader;
}

Error McapReader::in_chunk(std::size_t chunk, const char* what) const {
  return in_chunk(chunk, Error{.what = what, .where = {}, .fix = {}});
}

Error McapReader::in_chunk(std::size_t chunk, const Error& error) const {
  return mcap::in_chunk(*source_, chunk, summary_.chunks[chunk].chunk_start_offset, error);
}

bool McapReader::wanted(std::size_t chunk) const {
  const ChunkIndex& index = summary_.chunks[chunk];
  if (index.message_end_time < from_ || index.message_start_time > last_) return false;
  if (index.message_index_offsets.empty()) return true;  // no index of the chunk: it may contain any channel
  return std::any_of(index.message_index_offsets.begin(), index.message_index_offsets.end(), [&](const auto& entry) {
    return channels_.contains(entry.first) || summary_.channels.find(entry.first) == nullptr;
  });
}

void McapReader::select(const McapSelection& selection) {
  open_.clear();
  order_.clear();
  open_bytes_ = 0;
  channels_.clear();
  topics_ = selection.topics;
  for (const auto& [id, stored] : summary_.channels.all())
    if (matches_any(topics_, stored.channel.topic)) channels_.insert(id);
  from_ = selection.from ? mcap::stored_time(*selection.from) : 0;
  const bool nothing = selection.until && mcap::stored_time(*selection.until) == 0;
  last_ = selection.until && !nothing ? mcap::stored_time(*selection.until) - 1 : UINT64_MAX;
  to_open_.clear();
  for (std::size_t chunk = 0; chunk < summary_.chunks.size() && !nothing; ++chunk)
    if (wanted(chunk)) to_open_.push_back(chunk);
  std::sort(to_open_.begin(), to_open_.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(summary_.chunks[a].message_start_time, a) > std::pair(summary_.chunks[b].message_start_time, b);
  });
}

std::optional<SessionTime> McapReader::last_key_frame(const Topic& topic, SessionTime at) {
  const std::uint64_t before = mcap::stored_time(at);
  std::optional<std::uint64_t> last;
  for (const auto& [id, stored] : summary_.channels.all()) {
    if (!stored.topic || stored.topic->name != topic.name || stored.key_frames != true) continue;
    for (auto chunk = summary_.chunks.rbegin(); chunk != summary_.chunks.rend(); ++chunk)
      if (chunk->message_start_time < before && chunk->message_end_time >= last.value_or(0))
        last = std::max(last, last_in_chunk(*chunk, id, before));
  }
  if (!last || *last > INT64_MAX) return std::nullopt;
  return session_time(static_cast<std::int64_t>(*last));
}

/// Log time of the last message of `channel` before `before`, by the chunk's index. nullopt: none, or no valid index.
std::optional<std::uint64_t> McapReader::last_in_chunk(const ChunkIndex& chunk, std::uint16_t channel,
                                                       std::uint64_t before) {
  const auto at = chunk.message_index_offsets.find(channel);
  if (at == chunk.message_index_offsets.end()) return std::nullopt;
  std::string content;
  const Result<mcap::RecordHead> head = mcap::read_head(*source_, at->second, source_->size());
  if (!head || head->opcode != mcap::Opcode::MessageIndex || !mcap::read_content(*source_, *head, content))
    return std::nullopt;
  const auto index = mcap::parse<mcap::MessageIndex>(content);
  std::optional<std::uint64_t> last;
  if (index && index->channel_id == channel)
    for (const mcap::MessageIndex::Entry& entry : index->entries)
      if (entry.log_time < before) last = std::max(last, std::optional(entry.log_time));
  return last;
}

Result<void> McapReader::read_record(std::uint64_t offset, std::uint64_t length, mcap::Opcode opcode,
                                     std::string& into) {
  if (length > source_->size() || offset > source_->size() - length)
    return mcap::damaged(*source_, "truncated", offset);
  const Result<mcap::RecordHead> head = mcap::read_head(*source_, offset, offset + length);
  if (!head) return head.error();
  if (head->opcode != opcode || head->end() != offset + length)
    return mcap::damaged(*source_, "its index is damaged: another record lies here than the index states", offset);
  return mcap::read_content(*source_, *head, into);
}

/// A summary need not repeat the definitions that a chunk contains.
void McapReader::learn(mcap::Opcode opcode, std::string_view content) {
  if (opcode == mcap::Opcode::Schema) {
    if (auto schema = mcap::parse<mcap::Schema>(content)) (void)summary_.channels.add(*std::move(schema));
  } else if (opcode == mcap::Opcode::Channel) {
    auto channel = mcap::parse<mcap::Channel>(content);
    if (!channel) return;
    const std::uint16_t id = channel->id;
    const bool is_new = summary_.channels.find(id) == nullptr;
    const bool asked = matches_any(topics_, channel->topic);
    if (summary_.channels.add(*std::move(channel)) && is_new && asked) channels_.insert(id);
  }
}

Result<void> McapReader::open_chunk(std::size_t chunk) {
  const ChunkIndex& index = summary_.chunks[chunk];
  std::string content;
  const Result<void> read = read_record(index.chunk_start_offset, index.chunk_length, mcap::Opcode::Chunk, content);
  if (!read) return in_chunk(chunk, read.error());
  const auto record = mcap::parse<mcap::ChunkRecord>(content);
  if (!record) return in_chunk(chunk, "its header is damaged");
  if (open_bytes_ + record->uncompressed_size > kMaxOpenBytes)
    return in_chunk(chunk, "the chunks that overlap in time with this chunk do not fit in 256 MiB");
  Result<std::string> records = mcap::unpack(*record);
  if (!records) return in_chunk(chunk, records.error());

  auto opened = std::make_unique<OpenChunk>();
  opened->records = std::move(records).value();
  mcap::ChunkWalk walk(opened->records);
  for (;;) {
    const auto entry = walk.next();
    if (!entry) return in_chunk(chunk, entry.error());
    if (!*entry) break;
    if ((*entry)->opcode != mcap::Opcode::Message) {
      learn((*entry)->opcode, (*entry)->content);
      continue;
    }
    const auto message = mcap::parse<MessageRecord>((*entry)->content);
    if (!message || summary_.channels.find(message->channel_id) == nullptr)
      return in_chunk(chunk, "a message is damaged, or the file does not define its channel");
    if (message->log_time < index.message_start_time || message->log_time > index.message_end_time)
      return in_chunk(chunk, "a message lies outside the time span that the index states");
    if (channels_.contains(message->channel_id) && message->log_time >= from_ && message->log_time <= last_)
      opened->messages.push_back(*message);
  }
  if (opened->messages.empty()) return {};
  std::reverse(opened->messages.begin(), opened->messages.end());
  std::stable_sort(opened->messages.begin(), opened->messages.end(),
                   [](const MessageRecord& a, const MessageRecord& b) { return a.log_time > b.log_time; });
  order_.insert({opened->messages.back().log_time, chunk});
  open_bytes_ += opened->records.size();
  open_[chunk] = std::move(opened);
  return {};
}

Result<std::optional<StoredMessage>> McapReader::next_stored() {
  spent_.reset();
  while (!to_open_.empty()) {
    const std::size_t chunk = to_open_.back();
    if (!order_.empty() && summary_.chunks[chunk].message_start_time > order_.begin()->log_time) break;
    to_open_.pop_back();
    if (const Result<void> opened = open_chunk(chunk); !opened) return opened.error();
  }
  if (order_.empty()) return std::optional<StoredMessage>{};
  const std::size_t chunk = order_.begin()->chunk;
  order_.erase(order_.begin());
  OpenChunk& from = *open_.at(chunk);
  const MessageRecord record = from.messages.back();
  from.messages.pop_back();
  if (from.messages.empty()) {
    open_bytes_ -= from.records.size();
    spent_ = std::move(open_.extract(chunk).mapped());
  } else {
    order_.insert({from.messages.back().log_time, chunk});
  }
  return std::optional{StoredMessage{summary_.channels.find(record.channel_id), record}};
}

Result<std::optional<Message>> McapReader::next() {
  for (;;) {
    const Result<std::optional<StoredMessage>> stored = next_stored();
    if (!stored) return stored.error();
    if (!*stored) return std::optional<Message>{};
    if (std::optional<Message> message = mcap::to_message(**stored)) return message;
  }
}

Result<mcap::Metadata> McapReader::read(const mcap::MetadataIndex& index) {
  std::string content;
  if (const Result<void> got = read_record(index.offset, index.length, mcap::Opcode::Metadata, content); !got)
    return got.error();
  auto metadata = mcap::parse<mcap::Metadata>(content);
  if (!metadata) return mcap::damaged(*source_, "a metadata record is damaged", index.offset);
  return *std::move(metadata);
}

Result<mcap::Attachment> McapReader::read(const mcap::AttachmentIndex& index) {
  std::string content;
  if (const Result<void> got = read_record(index.offset, index.length, mcap::Opcode::Attachment, content); !got)
    return got.error();
  auto attachment = mcap::parse<mcap::Attachment>(content);
  if (!attachment) return mcap::damaged(*source_, "an attachment is damaged", index.offset);
  return *std::move(attachment);
}

Result<SessionInfo> McapReader::session() {
  for (const mcap::MetadataIndex& index : summary_.metadata) {
    if (index.name != kSessionMetadata) continue;
    const Result<mcap::Metadata> metadata = read(index);
    if (!metadata) return metadata.error();
    return session_info(*metadata);
  }
  return SessionInfo{};
}

}  // namespace telepalp::wire
