#include "support/program/json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace telepalp::program {
namespace {

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      out += {'\\', letter};
    } else if (static_cast<unsigned char>(letter) < 0x20) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(letter)));
      out += escape.data();
    } else {
      out += letter;
    }
  }
  return out + '"';
}

}  // namespace

void Json::name(std::string_view key) {
  if (!first_) text_ += ',';
  if (depth_ > 0) text_ += '\n' + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  if (!key.empty()) text_ += quoted(key) + ": ";
  first_ = false;
}

void Json::begin(std::string_view key, char bracket) {
  name(key);
  text_ += bracket;
  ++depth_;
  first_ = true;
}

void Json::end(char bracket) {
  --depth_;
  if (!first_) text_ += '\n' + std::string(2 * static_cast<std::size_t>(depth_), ' ');
  text_ += bracket;
  first_ = false;
}

void Json::add(std::string_view key, double value) {
  if (!std::isfinite(value)) return add_null(key);
  name(key);
  std::array<char, 64> text{};
  text_.append(text.data(),
               std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 9).ptr);
}

void Json::add(std::string_view key, std::uint64_t value) {
  name(key);
  text_ += std::to_string(value);
}

void Json::add(std::string_view key, std::optional<std::uint64_t> value) {
  if (value)
    add(key, *value);
  else
    add_null(key);
}

void Json::add(std::string_view key, bool value) {
  name(key);
  text_ += value ? "true" : "false";
}

void Json::add(std::string_view key, std::string_view text) {
  name(key);
  text_ += quoted(text);
}

void Json::add_null(std::string_view key) {
  name(key);
  text_ += "null";
}

}  // namespace telepalp::program
