#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace telepalp::program {

/// Writes indented JSON. `key`: empty in a list. Doubles have 9 significant digits, or are null if they are not finite.
class Json {
 public:
  void begin_object(std::string_view key = {}) { begin(key, '{'); }
  void end_object() { end('}'); }
  void begin_list(std::string_view key) { begin(key, '['); }
  void end_list() { end(']'); }
  void add(std::string_view key, double value);
  void add(std::string_view key, std::uint64_t value);
  void add(std::string_view key, std::optional<std::uint64_t> value);
  void add(std::string_view key, bool value);
  void add(std::string_view key, std::string_view text);
  void add(std::string_view key, const char* text) { add(key, std::string_view(text)); }
  void add_null(std::string_view key);

  [[nodiscard]] std::string finish() && { return std::move(text_) + "\n"; }

 private:
  void begin(std::string_view key, char bracket);
  void end(char bracket);
  void name(std::string_view key);

  std::string text_;
  int depth_ = 0;
  bool first_ = true;
};

}  // namespace telepalp::program
