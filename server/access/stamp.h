#pragma once

#include <ctime>
#include <string>

#include "proto/keys/identity.h"

namespace telepalp::access {

/// `now` in UTC, as "2026-11-22T00:12:33Z". The order of such texts is the order of their times.
[[nodiscard]] inline std::string stamp(keys::WallTime now) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace telepalp::access
