#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::program {

struct Address {
  std::string host;
  std::uint16_t port = 0;
};

/// Parses `HOST:PORT`, with an IPv6 host in brackets and a port from 1 to 65535. `where`: option's name, for errors.
/// `default_port`: the port of an address that states none; empty: an address must state its port.
[[nodiscard]] Result<Address> parse_address(std::string_view text, std::string_view where,
                                            std::string_view default_port = {});

/// `HOST:PORT` as parse_address() reads it: an IPv6 host is in brackets.
[[nodiscard]] std::string to_text(const Address& address);

}  // namespace telepalp::program
