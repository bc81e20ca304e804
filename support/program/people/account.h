#pragma once

#include <string>

namespace telepalp::program {

/// The account on this machine under which the program runs: "account anna".
[[nodiscard]] std::string account();

}  // namespace telepalp::program
