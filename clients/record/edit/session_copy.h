#pragma once

#include <string>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/writer.h"

namespace telepalp::record {

/// A message of a session file with its own copy of the data: it stays valid when the reader goes on.
class KeptMessage {
 public:
  explicit KeptMessage(const wire::mcap::StoredMessage& stored)
      : channel_(stored.channel), record_(stored.record), data_(stored.record.data) {}

  [[nodiscard]] std::uint64_t log_time() const noexcept { return record_.log_time; }
  [[nodiscard]] std::size_t bytes() const noexcept { return data_.size(); }
  [[nodiscard]] Result<void> copy_to(wire::McapWriter& writer) const;

 private:
  const wire::mcap::StoredChannel* channel_;  // owned by the reader's summary
  wire::mcap::MessageRecord record_;
  std::string data_;
};

/// Copies all metadata but the record about the session, which a writer writes itself, and all attachments.
[[nodiscard]] Result<void> copy_notes(wire::McapReader& from, wire::McapWriter& to);

}  // namespace telepalp::record
