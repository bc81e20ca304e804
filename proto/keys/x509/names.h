#pragma once

#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::keys {

/// Error: `name` is not 1 to 64 letters, digits and ". _ @ -".
[[nodiscard]] Result<void> check_name(const std::string& name);

/// subjectAltName for a server that clients reach by `hosts`, names and addresses, in the form of OpenSSL's
/// configuration: "DNS:patient.example,IP:10.0.0.1". localhost, 127.0.0.1 and ::1 are added. Error: a host is neither a
/// name nor an address, or there are more than 13.
[[nodiscard]] Result<std::string> alt_names(std::vector<std::string> hosts);

/// nameConstraints (RFC 5280, 4.2.1.10) of an authority that may sign for `hosts` alone, critical, in the form of
/// OpenSSL's configuration. A name includes the names below it. An address may be a network, such as 10.0.0.0/8.
/// localhost, 127.0.0.1 and ::1 are added, so that neither names nor addresses are without a limit. Error: as for
/// alt_names(), or the length of a network's prefix is wrong.
[[nodiscard]] Result<std::string> name_limits(std::vector<std::string> hosts);

}  // namespace telepalp::keys
