#pragma once

#include <set>
#include <string>
#include <tuple>

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

/// Copies the notes of sessions to one new session: all attachments, and all metadata except the record
/// "telepalp.session", because McapWriter writes its own. An attachment that several sessions hold, such as the scene
/// of two parts of one recording, is copied once.
class NotesCopy {
 public:
  explicit NotesCopy(wire::McapWriter& to) : to_(to) {}
  [[nodiscard]] Result<void> add(wire::McapReader& from);

 private:
  [[nodiscard]] bool is_new(const wire::mcap::Attachment& attachment);

  wire::McapWriter& to_;
  std::set<std::tuple<std::string, std::size_t, std::size_t>> attached_;  // name, size and hash of the data
};

}  // namespace telepalp::record
