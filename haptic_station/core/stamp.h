#pragma once

#include <cstdint>

#include "proto/words/time.h"

namespace telepalp::core {

/// `at` as the messages carry it: nanoseconds of the session clock.
[[nodiscard]] inline std::uint64_t stamp(SessionTime at) noexcept {
  return static_cast<std::uint64_t>(to_nanoseconds(at));
}

}  // namespace telepalp::core
