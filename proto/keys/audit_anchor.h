#pragma once

#include <string>
#include <string_view>

#include "proto/keys/audit_chain.h"
#include "proto/keys/key_file.h"

namespace telepalp::keys {

/// A position of an audit log, signed with the server's key: "anchor time=… lines=… hash=… signature=…". The hashes of
/// a log have no key, so whoever may write the file could change a line and compute the hashes again, or cut lines off
/// at the end. A copy of an anchor that is kept elsewhere reveals both.
struct AuditAnchor {
  std::string time;  ///< UTC, as 2026-11-22T00:12:33Z
  AuditPosition end;
};

/// The anchor's line, without a newline. Error: `server` has no private key.
[[nodiscard]] Result<std::string> anchor_line(const AuditAnchor& anchor, const KeyFile& server);

/// Error: `line` is no anchor, or the private key of `certificate` (PEM) did not sign it.
[[nodiscard]] Result<AuditAnchor> read_anchor(std::string_view line, std::string_view certificate);

}  // namespace telepalp::keys
