#pragma once

#include <string>
#include <string_view>

namespace telepalp::program {

/// Writes one line to stderr: `HH:MM:SS.mmm program: text`, in local time. escaped() is applied to `text`, so that a
/// name from a peer cannot forge a line or move the cursor.
void log(std::string_view program, std::string_view text);

/// `text` with its control bytes, 0x00 to 0x1f and 0x7f, as \xNN.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace telepalp::program
