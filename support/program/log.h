#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace telepalp::program {

/// Writes one line to stderr: log_line(), or json_log_line() if the environment has TELEPALP_LOG=json.
void log(std::string_view program, std::string_view text);

/// `HH:MM:SS.mmm program: text` and a line end, in local time. escaped() is applied to `text`, so that a name from a
/// peer cannot forge a line or move the cursor.
[[nodiscard]] std::string log_line(std::chrono::system_clock::time_point at, std::string_view program,
                                   std::string_view text);
/// The same as a JSON object: {"time": "2026-11-22T00:12:33.125Z", "program": …, "text": …}.
[[nodiscard]] std::string json_log_line(std::chrono::system_clock::time_point at, std::string_view program,
                                        std::string_view text);

/// `text` with its control bytes, 0x00 to 0x1f and 0x7f, as \xNN.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace telepalp::program
