#pragma once

#include <string>

#include "proto/wire/mcap/reader.h"
#include "proto/wire/mcap/writer.h"

namespace telepalp::record {

/// A message of a session file, with a copy of its data: valid while its reader exists, even after the reader reads on.
class KeptMessage {
 public:
  explicit KeptMessage(const wire::mcap::StoredMessage& stored)
      : channel_(stored.channel), record_(stored.record), data_(stored.record.data) {}

  [[nodiscard]] std::uint64_t log_time() const noexcept { return record_.log_time; }
  /// Replaces the message's time by `time` [ns of the session clock].
  void place_at(std::uint64_t time) noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept { return data_.size(); }
  [[nodiscard]] Result<void> copy_to(wire::McapWriter& writer) const;

 private:
  const wire::mcap::StoredChannel* channel_;  // owned by the reader's summary
  wire::mcap::MessageRecord record_;
  std::string data_;
};

/// Copies all attachments and all metadata except the record "telepalp.session", because McapWriter writes its own.
[[nodiscard]] Result<void> copy_notes(wire::McapReader& from, wire::McapWriter& to);

}  // namespace telepalp::record
