#include "support/program/log.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>

namespace telepalp::program {
std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code >= 0x20 && code != 0x7f) {
      out += letter;
      continue;
    }
    char hex[8];
    std::snprintf(hex, sizeof hex, "\\x%02x", code);
    out += hex;
  }
  return out;
}

void log(std::string_view program, std::string_view text) {
  const auto now = std::chrono::system_clock::now();
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char stamp[32];
  std::snprintf(stamp, sizeof stamp, "%02d:%02d:%02d.%03d", local.tm_hour, local.tm_min, local.tm_sec,
                static_cast<int>(ms));
  const std::string line = std::string(stamp) + " " + escaped(program) + ": " + escaped(text) + "\n";
  std::fputs(line.c_str(), stderr);
}

}  // namespace telepalp::program
