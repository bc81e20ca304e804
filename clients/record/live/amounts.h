#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::record {

/// Parses a duration: "90", "90s", "1.5min", "2h", "250ms"; without a unit it is in seconds. `option`: for the error.
/// Error: no number of at least 0, an unknown unit, or more than 1000 days.
[[nodiscard]] Result<Nanoseconds> parse_duration(std::string_view text, std::string_view option);

/// Parses "500MB", "2GB", "1GiB" or a number of bytes. Error: no number above 0, an unknown unit, or more than 1 PB.
[[nodiscard]] Result<std::uint64_t> parse_size(std::string_view text, std::string_view option);

/// True if `text` is meant as an amount of bytes, also without B: "500MB", "500M"; false for a duration such as "5min".
[[nodiscard]] bool is_size(std::string_view text) noexcept;

}  // namespace telepalp::record
