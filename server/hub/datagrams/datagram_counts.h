#pragma once

#include <cstdint>

namespace telepalp::hub {

/// Numbers of datagrams that arrived at the server's UDP port.
struct DatagramCounts {
  std::uint64_t taken = 0;      ///< accepted
  std::uint64_t strangers = 0;  ///< named no running session: noise, or a session that has ended
  std::uint64_t malformed = 0;  ///< named a session, but its size, version or key epoch is not one in use
  std::uint64_t replayed = 0;   ///< named a session, and came a second time
  std::uint64_t forged = 0;     ///< named a session, and the authentication tag is wrong
};

}  // namespace telepalp::hub
