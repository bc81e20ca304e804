#pragma once

#include <string>
#include <string_view>

namespace telepalp::program {

/// One line to stderr: `HH:MM:SS.mmm program: text`. Control characters in `text` are escaped, so that a name
/// from a peer cannot forge a line or move the cursor.
void log(std::string_view program, std::string_view text);

/// `text` with control characters as \xNN: safe to print, whoever wrote it.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace telepalp::program
