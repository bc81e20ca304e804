#include "clients/record/edit/session_copy.h"

namespace telepalp::record {

void KeptMessage::place_at(std::uint64_t time) noexcept { record_.log_time = record_.publish_time = time; }

Result<void> KeptMessage::copy_to(wire::McapWriter& writer) const {
  wire::mcap::MessageRecord record = record_;
  record.data = data_;
  return writer.copy(channel_->schema, channel_->channel, record);
}

Result<void> copy_notes(wire::McapReader& from, wire::McapWriter& to) {
  for (const wire::mcap::MetadataIndex& index : from.summary().metadata) {
    if (index.name == wire::kSessionMetadata) continue;
    const Result<wire::mcap::Metadata> metadata = from.read(index);
    if (!metadata) return metadata.error();
    if (const Result<void> added = to.add(*metadata); !added) return added;
  }
  for (const wire::mcap::AttachmentIndex& index : from.summary().attachments) {
    const Result<wire::mcap::Attachment> attachment = from.read(index);
    if (!attachment) return attachment.error();
    if (const Result<void> added = to.add(*attachment); !added) return added;
  }
  return {};
}

}  // namespace telepalp::record
