#pragma once

#include <boost/asio/ip/address.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace telepalp::ice {

inline constexpr std::size_t kMostCandidates = 32;  ///< of one end in one attempt
inline constexpr std::size_t kMostCandidateBytes = 160;

/// An address at which an end may be reached by UDP (RFC 8445 §5.1).
struct Candidate {
  enum class Kind {
    Host,       ///< of the computer itself
    Reflexive,  ///< of the router before it, as somebody outside sees it
    Relayed,    ///< of a relay
  };
  std::string foundation;  ///< equal for candidates of one kind, base and server (RFC 8445 §5.1.1.3)
  std::uint32_t priority = 0;
  boost::asio::ip::address address;
  std::uint16_t port = 0;
  Kind kind = Kind::Host;
};

/// Where connectivity checks may be sent to.
enum class Reach {
  Network,   ///< unicast addresses of other computers
  Loopback,  ///< this computer, too: for tests
};

/// False for addresses to which no peer may point this program: unspecified, loopback, link-local, multicast,
/// broadcast, and IPv4 addresses written as IPv6.
[[nodiscard]] bool may_check(const boost::asio::ip::address& address, Reach reach);

/// Reads a candidate as RFC 8839 §5.1 writes it, without extensions:
/// `candidate:1 1 udp 2015363327 10.0.0.5 40000 typ host`. nullopt: malformed, longer than kMostCandidateBytes, not
/// UDP, not of component 1, with a name instead of an address, or may_check() forbids the address.
[[nodiscard]] std::optional<Candidate> read_candidate(std::string_view text, Reach reach);
[[nodiscard]] std::string to_text(const Candidate& candidate);

/// True for what may be a user or a password of connectivity checks: `least` to 256 characters of RFC 8839's ice-char.
[[nodiscard]] bool is_credential(std::string_view text, std::size_t least);

}  // namespace telepalp::ice
