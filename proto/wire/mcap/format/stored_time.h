#pragma once

#include <algorithm>
#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::wire::mcap {

/// `at` as a file stores it [ns]; an instant before the session's zero is stored as 0.
[[nodiscard]] inline std::uint64_t stored_time(SessionTime at) noexcept {
  return static_cast<std::uint64_t>(std::max<std::int64_t>(to_nanoseconds(at), 0));
}

}  // namespace telepalp::wire::mcap
