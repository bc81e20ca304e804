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

/// A measurement file's text, at most 16 MiB.
[[nodiscard]] Result<std::string> read_rows(const std::filesystem::path& file);

/// Takes the first line off a text, without its end.
[[nodiscard]] std::string_view next_line(std::string_view& text) noexcept;

/// A row's numbers, comma between; nullopt when there are more or fewer, or one is not finite. from_chars knows no
/// locale, so a decimal comma makes numbers too many.
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
