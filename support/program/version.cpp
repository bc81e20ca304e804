#include "support/program/version.h"

namespace telepalp::program {

const char* version() noexcept { return TELEPALP_VERSION; }

// A program has another one instead, in the file that cmake/write_commit.cmake writes. A test has this one.
[[gnu::weak]] const char* commit() noexcept { return ""; }

}  // namespace telepalp::program
