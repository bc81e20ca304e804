#pragma once

#include <string>
#include <string_view>

namespace telepalp::bench {

struct Damage {
  std::string bytes;  ///< the damaged session; they differ from the session's
  std::string what;   ///< "a byte flipped in ChunkIndex at byte 81233"
};

/// Damage `number` of the session file `session`, an MCAP file with a summary or the first part of one. Even numbers
/// flip a byte, in each kind of record in turn; odd ones cut the tail, swap two blocks, zero a page or a CRC, remove,
/// repeat or append bytes, in turn. The same number gives the same damage.
[[nodiscard]] Damage damaged(std::string_view session, unsigned number);

}  // namespace telepalp::bench
