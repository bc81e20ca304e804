#pragma once

#include <version>

// Debian 12's default clang, 14, lacks the builtin that libstdc++'s <source_location> needs, so the header is empty
// there. This file replaces it in the fuzz targets only; a newer clang ignores it.
#if !__has_builtin(__builtin_source_location)
namespace std {
struct source_location {
  static constexpr source_location current(const char* file = __builtin_FILE(), unsigned line = __builtin_LINE(),
                                           const char* function = __builtin_FUNCTION()) noexcept {
    return {file, line, function};
  }
  constexpr const char* file_name() const noexcept { return file_; }
  constexpr unsigned line() const noexcept { return line_; }
  constexpr const char* function_name() const noexcept { return function_; }
  const char* file_;
  unsigned line_;
  const char* function_;
};
}  // namespace std
#endif
