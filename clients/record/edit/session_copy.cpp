#include "clients/record/edit/session_copy.h"

#include <functional>

namespace telepalp::record {

void KeptMessage::place_at(std::uint64_t time) noexcept { record_.log_time = record_.publish_time = time; }

Result<void> KeptMessage::copy_to(wire::McapWriter& writer) const {
  wire::mcap::MessageRecord record = record_;
  record.data = data_;
  return writer.copy({channel_, record});
}

bool NotesCopy::is_new(const wire::mcap::Attachment& attachment) {
  return attached_.emplace(attachment.name, attachment.data.size(), std::hash<std::string>{}(attachment.data)).second;
}

Result<void> NotesCopy::add(wire::McapReader& from) {
  for (const wire::mcap::MetadataIndex& index : from.summary().metadata) {
    if (index.name == wire::kSessionMetadata) continue;
    const Result<wire::mcap::Metadata> metadata = from.read(index);
    if (!metadata) return metadata.error();
    if (const Result<void> added = to_.add(*metadata); !added) return added;
  }
  for (const wire::mcap::AttachmentIndex& index : from.summary().attachments) {
    const Result<wire::mcap::Attachment> attachment = from.read(index);
    if (!attachment) return attachment.error();
    if (!is_new(*attachment)) continue;
    if (const Result<void> added = to_.add(*attachment); !added) return added;
  }
  return {};
}

}  // namespace telepalp::record
