#pragma once

#include <cstdio>
#include <cstdlib>
#include <source_location>

namespace telepalp {

/// An assertion that is active in release builds too: if `holds` is false, prints `claim` and the position of the
/// call, and aborts. It is for bugs in telepalp only. Errors of a peer, a file or a device return a Result. Never used
/// on the haptic thread.
inline void demand(bool holds, const char* claim, const std::source_location& at = std::source_location::current()) {
  if (holds) [[likely]]
    return;
  std::fprintf(stderr,
               "telepalp bug: this should be true but is not: %s (%s:%u in %s); the program ends. fix: report this "
               "line to the developers of telepalp, then start the program again\n",
               claim, at.file_name(), static_cast<unsigned>(at.line()), at.function_name());
  std::abort();
}

}  // namespace telepalp
