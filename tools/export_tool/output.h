#pragma once

#include <string>

#include "support/program/options.h"

namespace telepalp::export_tool {

/// Writes `bytes` to the file of `--out`, or to stdout. Returns the exit code.
[[nodiscard]] int put(const program::Arguments& asked, const std::string& bytes);

}  // namespace telepalp::export_tool
