#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "support/program/options.h"

namespace telepalp::program {

using Patience = std::optional<std::chrono::duration<double>>;  ///< time limit; nullopt: unlimited

/// Stands for "unlimited" where the type cannot express it: 10^7 s, about four months.
inline constexpr std::chrono::duration<double> kForEver{1e7};

/// The option `--patience S`: how many seconds a program waits for its peer; 0: unlimited. `help`: its help text.
[[nodiscard]] Option patience_option(std::string_view help, std::string_view initial_s = "30");

[[nodiscard]] Result<Patience> patience_of(const Arguments& arguments);

}  // namespace telepalp::program
