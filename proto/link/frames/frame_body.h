#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "proto/link/format/fragment.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// Size of the capture time that precedes a frame's bytes. SharedFrame writes it.
inline constexpr std::size_t kStampBytes = sizeof(std::int64_t);

/// The capture time in `body`; 0 for a negative one, which no correct peer sends and whose age would overflow.
[[nodiscard]] inline SessionTime stamp_of(std::span<const std::byte> body) noexcept {
  return session_time(std::max<std::int64_t>(0, get_little_endian<std::int64_t>(body.data())));
}

}  // namespace telepalp::link
