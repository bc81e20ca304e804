#pragma once

#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::nats {

/// Where a cluster of NATS servers is, and how to enter it.
struct Address {
  std::string url;            ///< nats://[USER:PASSWORD@]HOST[:PORT], or tls://…; several, with commas
  std::string credentials{};  ///< NATS's credentials file (.creds); empty: none
  std::string authority{};    ///< file with the certificate of a tls:// server's authority; empty: the system's
};

/// True if `text` begins as the address of a cluster does: nats:// or tls://.
[[nodiscard]] bool is_address(std::string_view text) noexcept;

/// Reads `nats://HOST[:PORT][?creds=FILE][&ca=FILE]`. `where`: the option's name, for errors.
[[nodiscard]] Result<Address> parse_address(std::string_view text, std::string_view where);

/// `url` without names and passwords, for logs. Of several servers it keeps only those after the last password, because
/// a password may contain a comma.
[[nodiscard]] std::string without_password(const std::string& url);

}  // namespace telepalp::nats
