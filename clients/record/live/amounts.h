#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::record {

/// Parses a duration: "90" (seconds), "90s", "1.5min", "2h", "250ms". `option`: the option's name without "--", for
/// the error. Error: not a number, a negative number, an unknown unit, or more than 1000 days.
[[nodiscard]] Result<Nanoseconds> parse_duration(std::string_view text, std::string_view option);

/// Parses "500MB", "2GB", "1GiB" or a number of bytes. Error: not a number, under 1 B, an unknown unit, or over 1 PB.
[[nodiscard]] Result<std::uint64_t> parse_size(std::string_view text, std::string_view option);

/// True if `text` ends in B, k, M or G, like "500MB" or "500M". False for "500" and for a duration such as "5min".
[[nodiscard]] bool is_size(std::string_view text) noexcept;

}  // namespace telepalp::record
