#include "haptic_station/solids/text/tokens.h"

namespace telepalp::solids {
namespace {

bool is_space(char letter) noexcept {
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n' || letter == '\v' || letter == '\f';
}

}  // namespace

void Tokens::advance() noexcept {
  if (text_[at_++] == '\n') {
    ++line_;
    column_ = 1;
  } else {
    ++column_;
  }
}

void Tokens::skip() noexcept {
  while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == '#')) {
    if (text_[at_] == '#')
      while (at_ < text_.size() && text_[at_] != '\n') advance();
    else
      advance();
  }
}

Token Tokens::next() noexcept {
  skip();
  Token token{{}, line_, column_};
  const std::size_t first = at_;
  while (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != '#') advance();
  token.text = text_.substr(first, at_ - first);
  return token;
}

}  // namespace telepalp::solids
