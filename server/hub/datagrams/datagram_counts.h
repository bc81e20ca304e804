#pragma once

#include <cstdint>

namespace telepalp::hub {

/// What came to the server's UDP port.
struct DatagramCounts {
  std::uint64_t taken = 0;
  std::uint64_t strangers = 0;  ///< of no session: garbage, or of a session that has ended
  std::uint64_t malformed = 0;  ///< of a session, under a key that is not in use
  std::uint64_t replayed = 0;
  std::uint64_t forged = 0;  ///< of a session, and the tag is wrong
};

}  // namespace telepalp::hub
