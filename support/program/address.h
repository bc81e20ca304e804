#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::program {

struct Address {
  std::string host;
  std::uint16_t port = 0;
  std::string site{};  ///< name of a site that is reached through the meeting point at host:port; empty: none
};

/// Parses `HOST:PORT`, with an IPv6 host in brackets and a port from 1 to 65535. `where`: option's name, for errors.
/// `default_port`: the port of an address that states none; empty: an address must state its port.
[[nodiscard]] Result<Address> parse_address(std::string_view text, std::string_view where,
                                            std::string_view default_port = {});

/// Parses the server that a client's --connect names: `HOST[:PORT]`, by default port 7400; or `SITE@HOST[:PORT]`, a
/// site that is reached through the meeting point HOST, by default port 443.
[[nodiscard]] Result<Address> parse_server(std::string_view text, std::string_view where);

/// `[SITE@]HOST:PORT` as parse_server() reads it: an IPv6 host is in brackets.
[[nodiscard]] std::string to_text(const Address& address);

}  // namespace telepalp::program
