#pragma once

#include <string>

#include "support/program/options.h"
#include "tools/export_tool/deidentify/deidentified_session.h"

namespace telepalp::export_tool {

/// The report as text: one line for each kind of content that was removed, replaced or kept, and then what in the copy
/// can still identify a person. Holds no text of the session.
[[nodiscard]] std::string in_words(const Deidentified& report, ColorRule color);

/// Runs telepalp-export SESSION --deidentify FILE.mcap; prints the report, or writes it to --out. Returns the exit
/// code.
[[nodiscard]] int deidentify_command(const std::string& session, const program::Arguments& asked);

}  // namespace telepalp::export_tool
