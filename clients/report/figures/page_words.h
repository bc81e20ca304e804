#pragma once

#include <string>

namespace telepalp::report {

/// The section of the page that says what its words mean.
[[nodiscard]] std::string page_words_section();

}  // namespace telepalp::report
