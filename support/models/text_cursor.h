#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "proto/words/number_word.h"

namespace telepalp::models {

/// Reads text by lines and words without copying. number(): a decimal point in every locale; nullopt: not a number.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) noexcept : text_(text) {}
  explicit TextCursor(std::span<const std::byte> bytes) noexcept
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  [[nodiscard]] bool at_end() const noexcept { return at_ >= text_.size(); }
  [[nodiscard]] std::size_t offset() const noexcept { return at_; }
  /// Number of lines that line() has read; word() does not count the line ends that it passes.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_; }

  /// Reads from the present position to the end of the line, and returns this text without the line end.
  std::string_view line() noexcept {
    const std::size_t end = text_.find('\n', at_);
    std::string_view line = text_.substr(at_, end == std::string_view::npos ? end : end - at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  /// Reads the next word, also from following lines; empty at the end of the text.
  std::string_view word() noexcept { return take_word(text_, at_); }

  /// Removes the first word from `rest` and returns it.
  static std::string_view word_of(std::string_view& rest) noexcept {
    std::size_t at = 0;
    const std::string_view word = take_word(rest, at);
    rest.remove_prefix(at);
    return word;
  }

  template <class Number>
  static std::optional<Number> number(std::string_view word) noexcept {
    return signed_number_of<Number>(word);
  }

 private:
  static bool is_space(char letter) noexcept {
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
  }
  static std::string_view take_word(std::string_view text, std::size_t& at) noexcept {
    while (at < text.size() && is_space(text[at])) ++at;
    const std::size_t start = at;
    while (at < text.size() && !is_space(text[at])) ++at;
    return text.substr(start, at - start);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
};

}  // namespace telepalp::models
