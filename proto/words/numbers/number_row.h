#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace telepalp {

/// The N comma-separated numbers of a line; nullopt when the count differs or a number is not finite. std::from_chars
/// ignores the locale, so a decimal comma gives too many numbers and is refused.
template <std::size_t N>
[[nodiscard]] std::optional<std::array<double, N>> number_row(std::string_view line) noexcept {
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

/// Removes the first line from `text` and returns it without its line end.
[[nodiscard]] inline std::string_view take_line(std::string_view& text) noexcept {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace telepalp
