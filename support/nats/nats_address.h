#pragma once

#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::nats {

/// Where a cluster of NATS servers is, and how to enter it.
struct Address {
  std::string url;            ///< nats://[USER:PASSWORD@]HOST[:PORT], or tls://…; several are separated by commas
  std::string credentials{};  ///< NATS's credentials file (.creds); empty: none
  std::string authority{};    ///< file with the certificate of a tls:// server's authority; empty: the system's
};

/// True if `text` begins as the address of a cluster does: nats:// or tls://.
[[nodiscard]] bool is_address(std::string_view text) noexcept;

/// Reads `nats://HOST[:PORT][?creds=FILE][&ca=FILE]`. `where`: the option's name, for errors.
[[nodiscard]] Result<Address> parse_address(std::string_view text, std::string_view where);

/// `address`, with or without its ?creds=FILE, without users and passwords: for logs and lines to paste. Of several
/// servers only those after the last password are kept, because a password may contain a comma.
[[nodiscard]] std::string without_password(const std::string& address);

}  // namespace telepalp::nats
