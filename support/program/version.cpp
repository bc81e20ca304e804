#include "support/program/version.h"

namespace telepalp::program {

const char* version() noexcept { return TELEPALP_VERSION; }

// A program replaces this weak function by the one in the file that cmake/write_commit.cmake writes; a test uses this
// one.
[[gnu::weak]] const char* commit() noexcept { return ""; }

std::string software(std::string_view program) {
  const std::string built_from = commit();
  return std::string(program) + " " + version() + (built_from.empty() ? "" : ", commit " + built_from);
}

}  // namespace telepalp::program
