#pragma once

#include <chrono>
#include <ctime>
#include <string>

namespace telepalp {

/// `at` in UTC, in the form `format` of strftime(); at most 63 bytes.
[[nodiscard]] inline std::string utc_text(std::chrono::system_clock::time_point at, const char* format) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(at);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &parts)};
}

/// `at` in UTC, as "2026-11-22T00:12:33Z" (ISO 8601). The order of such texts is the order of their times.
[[nodiscard]] inline std::string utc_stamp(std::chrono::system_clock::time_point at) {
  return utc_text(at, "%Y-%m-%dT%H:%M:%SZ");
}

}  // namespace telepalp
