#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace telepalp::meet {

/// The part of a TLS ClientHello that tells whom a caller wants. It is not encrypted (RFC 8446 §4.1.2).
struct ClientHello {
  std::string server_name;   ///< in lower case (RFC 6066 §3); empty: the caller names nobody
  bool speaks_http = false;  ///< it offers HTTP/1.1 or HTTP/2 (RFC 7301), as browsers do
};

struct HelloRead {
  enum class State { Incomplete, Whole, NotTls };
  State state = State::Incomplete;
  ClientHello hello;  ///< valid if Whole
};

/// Longest ClientHello that is read, its record headers included. A longer one is NotTls.
inline constexpr std::size_t kMostHelloBytes = std::size_t{16} * 1024;

/// Reads the ClientHello in the first bytes of a connection. Consumes nothing: the bytes go on to the site as they are.
[[nodiscard]] HelloRead read_client_hello(std::span<const std::byte> bytes);

}  // namespace telepalp::meet
