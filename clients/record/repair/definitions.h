#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proto/wire/mcap/reader.h"

namespace telepalp::record {

/// Definitions of a session without a CRC, compared with this program's own. A file that this very version wrote holds
/// them unchanged, so that each difference is a damage. In a file of another version a difference may also
/// be the version's, so none counts as a damage.
class DefinitionCheck {
 public:
  explicit DefinitionCheck(const wire::SessionInfo& session);

  /// The damaged definitions among `channels`, one text for each.
  [[nodiscard]] std::vector<std::string> damaged(const wire::mcap::ChannelTable& channels) const;
  /// This program's own definition in place of a damaged one; nullptr: it is not damaged, or neither its topic nor its
  /// type can be recognised.
  [[nodiscard]] const wire::mcap::StoredChannel* mended(const wire::mcap::StoredChannel& channel);

 private:
  struct Definition {
    wire::mcap::Schema schema;
    wire::mcap::StoredChannel channel;  // its schema is the one above
  };
  bool is_of_this_version_;
  std::map<std::uint16_t, std::optional<Definition>> mended_;  // by the channel's id
};

}  // namespace telepalp::record
