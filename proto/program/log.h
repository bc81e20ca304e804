#pragma once

#include <string_view>

namespace telepalp::program {

/// One line to stderr: `HH:MM:SS.mmm program: text`. Control characters in `text` are escaped, so that a name
/// from a peer cannot forge a line or move the cursor.
void log(std::string_view program, std::string_view text);

}  // namespace telepalp::program
