#pragma once

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// A certificate that is valid for less than this gives a note.
inline constexpr std::chrono::days kRenewInTime{30};

/// Until when a certificate is valid: a note if it ends within kRenewInTime, else good. `whose`: as in "of ward3".
/// `expires` is after `now`.
[[nodiscard]] Finding validity(std::string what, const std::string& whose, keys::WallTime expires, keys::WallTime now);

/// Checks the server's key, the certificate for browsers, the list of revoked keys, and the audit log. Asks nobody for
/// a passphrase, and writes nothing.
[[nodiscard]] Findings check_keys(const Asked& asked, keys::WallTime now);

}  // namespace telepalp::server
