#pragma once

#include <string>
#include <string_view>

namespace telepalp::solids {

/// A word of the text and its position; lines and columns (bytes) count from 1.
struct Token {
  std::string_view text;
  int line = 1;
  int column = 1;
};

/// Splits text at white space; `#` begins a comment that ends with the line. `text` must outlive the tokens.
class Tokens {
 public:
  explicit Tokens(std::string_view text) noexcept : text_(text) {}
  /// The next word. At the end of the text: a token with empty `text`, at the position of the end.
  [[nodiscard]] Token next() noexcept;

 private:
  void skip() noexcept;
  void advance() noexcept;

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace telepalp::solids
