#pragma once

#include <cstdio>
#include <cstdlib>
#include <source_location>

namespace telepalp {

/// Our own bug if `holds` is false: says where, and aborts, in release builds too.
/// Never for what a peer, a file or a device did (that is a Result), never on the haptic thread.
inline void demand(bool holds, const char* claim, const std::source_location& at = std::source_location::current()) {
  if (holds) [[likely]]
    return;
  std::fprintf(stderr, "telepalp bug: %s (%s:%u in %s)\n", claim, at.file_name(), static_cast<unsigned>(at.line()),
               at.function_name());
  std::abort();
}

}  // namespace telepalp
