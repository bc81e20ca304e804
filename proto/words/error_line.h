#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp {

/// `text` up to its first line break. Messages of libraries may have more lines, but an Error is printed as one line.
[[nodiscard]] inline std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

/// A number for an error message: the shortest text that reads back as `value`. From 1e-7 to 1e12 it has no exponent.
[[nodiscard]] inline std::string number_text(double value) {
  const bool plain = value == 0.0 || (std::abs(value) >= 1e-7 && std::abs(value) < 1e12);
  char text[64];
  const auto format = plain ? std::chars_format::fixed : std::chars_format::general;
  return {text, std::to_chars(text, text + sizeof text, value, format).ptr};
}

/// The error that another program printed or sent as the line `what. fix: fix` of to_string(). `where` is empty: a
/// place in the line remains a part of `what`. A line without a fix becomes `what` as a whole.
[[nodiscard]] inline Error error_in(std::string_view line) {
  constexpr std::string_view kFix = ". fix: ";
  const std::size_t at = line.find(kFix);
  if (at == std::string_view::npos) return {.what = std::string(line), .where = {}, .fix = {}};
  return {.what = std::string(line.substr(0, at)), .where = {}, .fix = std::string(line.substr(at + kFix.size()))};
}

}  // namespace telepalp
