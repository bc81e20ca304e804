#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace telepalp {

/// The number that the whole text spells; nullopt: it spells none. from_chars ignores the locale, so the decimal point
/// is a point, and a comma never is one. A leading plus is no part of a number, "inf" and "nan" are numbers.
template <class Number = double>
[[nodiscard]] std::optional<Number> number_of(std::string_view text) noexcept {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// As number_of(); nullopt for "inf" and "nan", too.
[[nodiscard]] inline std::optional<double> finite_number_of(std::string_view text) noexcept {
  const std::optional<double> value = number_of(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// As number_of(), of a text that may begin with a plus.
template <class Number = double>
[[nodiscard]] std::optional<Number> signed_number_of(std::string_view text) noexcept {
  return number_of<Number>(text.starts_with('+') ? text.substr(1) : text);
}

}  // namespace telepalp
