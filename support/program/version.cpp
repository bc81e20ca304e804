#include "support/program/version.h"

namespace telepalp::program {

const char* version() noexcept { return TELEPALP_VERSION; }

// A program replaces this weak function by the one in the file that cmake/write_commit.cmake writes; a test uses this
// one.
[[gnu::weak]] const char* commit() noexcept { return ""; }

}  // namespace telepalp::program
