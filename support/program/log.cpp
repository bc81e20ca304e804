#include "support/program/log.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "proto/words/numbers/utc_text.h"
#include "support/program/json.h"

namespace telepalp::program {
namespace {

/// Number of bytes of the control character that begins `text`; 0: `text` begins with another character. The control
/// characters U+0080 to U+009F (C1) are two bytes in UTF-8, and some terminals obey them like an escape sequence.
std::size_t control_bytes(std::string_view text) noexcept {
  const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f ? 2 : 0;
}

int millisecond_of(std::chrono::system_clock::time_point at) noexcept {
  return static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count() % 1000);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t controls = control_bytes(text);
    if (controls == 0) out += text.front();
    for (std::size_t i = 0; i < controls; ++i) {
      std::array<char, 8> hex{};
      std::snprintf(hex.data(), hex.size(), "\\x%02x", static_cast<unsigned char>(text[i]));
      out += hex.data();
    }
    text.remove_prefix(std::max<std::size_t>(controls, 1));
  }
  return out;
}

std::string log_line(std::chrono::system_clock::time_point at, std::string_view program, std::string_view text) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(at);
  std::tm local{};
  localtime_r(&seconds, &local);
  char stamp[32];
  std::snprintf(stamp, sizeof stamp, "%02d:%02d:%02d.%03d", local.tm_hour, local.tm_min, local.tm_sec,
                millisecond_of(at));
  return std::string(stamp) + " " + escaped(program) + ": " + escaped(text) + "\n";
}

std::string json_log_line(std::chrono::system_clock::time_point at, std::string_view program, std::string_view text) {
  char millisecond[8];
  std::snprintf(millisecond, sizeof millisecond, ".%03dZ", millisecond_of(at));
  Json json;
  json.begin_object();
  json.add("time", utc_text(at, "%Y-%m-%dT%H:%M:%S") + millisecond);
  json.add("program", escaped(program));
  json.add("text", escaped(text));
  json.end_object();
  std::string line = std::move(json).finish();
  std::erase(line, '\n');
  return line + "\n";
}

void log(std::string_view program, std::string_view text) {
  static const bool in_json = [] {
    const char* form = std::getenv("TELEPALP_LOG");
    return form != nullptr && std::string_view(form) == "json";
  }();
  const auto now = std::chrono::system_clock::now();
  std::fputs((in_json ? json_log_line(now, program, text) : log_line(now, program, text)).c_str(), stderr);
}

}  // namespace telepalp::program
