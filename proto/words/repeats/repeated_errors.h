#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "proto/words/result.h"

namespace telepalp {

/// Log lines about errors that may come many times a second, such as a damaged stream: the first error of a kind gives
/// a line at once, and while the error repeats, every 5 s a line with its count. Pure: the caller gives the time.
/// Owner: one thread.
class RepeatedErrors {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  /// Counts `error`. Errors are of one kind if their `what` is the same. Returns the line when one is due: "`happened`:
  /// error", later "`happened`, 151 so far for this reason: error", such as "depth image dropped, 151 so far …".
  [[nodiscard]] std::optional<std::string> line(const std::string& happened, const Error& error, TimePoint now);

 private:
  struct Kind {
    std::uint64_t count = 0;
    TimePoint next_line;
  };
  std::map<std::string, Kind> kinds_;  // by Error::what
};

}  // namespace telepalp
