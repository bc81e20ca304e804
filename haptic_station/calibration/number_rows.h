#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::calibration {

/// Reads the text of a measurement file. Error: the file cannot be read, or is larger than 16 MiB.
[[nodiscard]] Result<std::string> read_rows(const std::filesystem::path& file);

/// Removes the first line from `text` and returns it without its line end.
[[nodiscard]] std::string_view next_line(std::string_view& text) noexcept;

/// Parses a row of N comma-separated numbers; nullopt when the count differs or a number is not finite. std::from_chars
/// ignores the locale, so a decimal comma gives too many numbers and is refused.
template <std::size_t N>
[[nodiscard]] std::optional<std::array<double, N>> numbers(std::string_view line) noexcept {
  std::array<double, N> out{};
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t i = 0; i < N; ++i) {
    const auto [stop, error] = std::from_chars(at, end, out[i]);
    if (error != std::errc{} || !std::isfinite(out[i])) return std::nullopt;
    const bool last = i + 1 == N;
    if (last != (stop == end) || (!last && *stop != ',')) return std::nullopt;
    at = stop + 1;
  }
  return out;
}

}  // namespace telepalp::calibration
