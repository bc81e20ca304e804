#include "support/program/text/quoted_text.h"

#include <algorithm>
#include <cctype>

namespace telepalp::program {
namespace {

bool is_space(char c) noexcept { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_hex(char c) noexcept { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }
bool is_octal(char c) noexcept { return c >= '0' && c <= '7'; }

/// One past the character that begins at `at`: an escape such as \n, \101 or \x41 is one character.
std::size_t past_character(std::string_view source, std::size_t at) noexcept {
  if (source[at] != '\\' || at + 1 >= source.size()) return at + 1;
  const bool hex = source[at + 1] == 'x';
  if (!hex && !is_octal(source[at + 1])) return at + 2;
  std::size_t end = at + (hex ? 2 : 1);
  const std::size_t most = end + (hex ? 2 : 3);
  while (end < std::min(most, source.size()) && (hex ? is_hex(source[end]) : is_octal(source[end]))) ++end;
  return end;
}

/// The first byte from `at` on that is neither space nor in a comment.
std::size_t past_space(std::string_view source, std::size_t at) noexcept {
  while (at < source.size() && (is_space(source[at]) || source[at] == '#'))
    at = source[at] == '#' ? std::min(source.find('\n', at), source.size()) : at + 1;
  return at;
}

bool continues(std::string_view text, std::size_t at) noexcept {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
}

/// Bytes of the letter that begins at `at`; 0: none begins there.
std::size_t letter_bytes(std::string_view text, std::size_t at) noexcept {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const std::size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < bytes; ++i)
    if (!continues(text, at + i)) return 0;
  const auto second = static_cast<unsigned char>(text[at + 1]);
  const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  return too_long || surrogate || (first == 0xF4 && second >= 0x90) ? 0 : bytes;
}

}  // namespace

std::size_t byte_of(std::string_view source, int line, int column) noexcept {
  std::size_t at = 0;
  for (; line > 0; --line) {
    const std::size_t end = source.find('\n', at);
    if (end == std::string_view::npos) return source.size();
    at = end + 1;
  }
  for (int reached = 0; reached < column && at < source.size() && source[at] != '\n'; ++at)
    reached = source[at] == '\t' ? (reached / 8 + 1) * 8 : reached + 1;
  return at;
}

TextPlace place_in_quoted(std::string_view source, std::size_t from, std::size_t offset) noexcept {
  std::size_t at = std::min(source.find_first_of("\"'", from), source.size());
  while (at < source.size() && (source[at] == '"' || source[at] == '\'')) {
    const char quote = source[at];
    for (++at; at < source.size() && source[at] != quote; at = past_character(source, at))
      if (offset-- == 0) return place_of(source, at);
    const std::size_t next = past_space(source, at + 1);
    if (next >= source.size() || (source[next] != '"' && source[next] != '\'')) break;
    at = next;
  }
  return place_of(source, std::min(at, source.size()));
}

TextPlace place_of(std::string_view source, std::size_t byte) noexcept {
  const std::string_view before = source.substr(0, byte);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = lines == 0 ? 0 : before.rfind('\n') + 1;
  return {static_cast<int>(lines) + 1, static_cast<int>(byte - line_start) + 1};
}

std::size_t valid_utf8_bytes(std::string_view text) noexcept {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t bytes = letter_bytes(text, at);
    if (bytes == 0) return at;
    at += bytes;
  }
  return at;
}

}  // namespace telepalp::program
