#pragma once

#include "server/command_line.h"
#include "server/finding.h"

namespace telepalp::server {

/// A certificate that ends in fewer days is noted.
inline constexpr std::chrono::days kRenewInTime{30};

/// What is to be said of a certificate's end, which lies after `now`: "valid until …", as a note if it is near.
[[nodiscard]] Finding validity(std::string what, const std::string& whose, keys::WallTime expires, keys::WallTime now);

/// The server's key, the certificate for browsers, the list of revoked keys, and the audit log. Nobody is asked for a
/// passphrase, and nothing is written.
[[nodiscard]] Findings check_keys(const Asked& asked, keys::WallTime now);

}  // namespace telepalp::server
