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

/// Reads `HOST:PORT`; an IPv6 host stands in brackets. `where` names the option in errors.
[[nodiscard]] Result<Address> parse_address(std::string_view text, std::string_view where);

}  // namespace telepalp::program
