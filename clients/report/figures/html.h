#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace telepalp::report {

/// The page's look: for screen and paper.
extern const std::string_view kStyle;

/// `bytes` in base64. Source: RFC 4648.
[[nodiscard]] std::string base64(std::string_view bytes);

/// A table; cells are text, escaped here. Columns after the first are numbers and stand to the right.
[[nodiscard]] std::string table(const std::vector<std::string>& head,
                                const std::vector<std::vector<std::string>>& rows);

/// A section with a heading and a line that says what is seen.
[[nodiscard]] std::string section(std::string_view heading, std::string_view explanation, const std::string& content);

}  // namespace telepalp::report
