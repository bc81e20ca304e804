#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace telepalp::report {

/// Style sheet of the page, for screen and print.
extern const std::string_view kStyle;

/// `bytes` in base64. Source: RFC 4648.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Content of the columns after the first one: numbers are right-aligned, words left-aligned.
enum class Cells { Numbers, Words };

/// An HTML table; the function escapes the cells' text.
[[nodiscard]] std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                                Cells cells = Cells::Numbers);

/// A section with a heading and one line of explanation.
[[nodiscard]] std::string section(std::string_view heading, std::string_view explanation, const std::string& content);

}  // namespace telepalp::report
