#pragma once

#include <string>

#include "support/program/options.h"

namespace telepalp::export_tool {

/// Runs `telepalp-export SESSION --foxglove FILE.mcap [--parts LIST] [--rate HZ]`: says on stderr how large the file
/// will be, then writes it. Returns the program's exit code.
int foxglove_command(const std::string& session, const program::Arguments& asked);

}  // namespace telepalp::export_tool
