#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "support/program/options.h"

namespace telepalp::program {

using Patience = std::optional<std::chrono::duration<double>>;  ///< time limit; nullopt: unlimited

/// Means "unlimited" where a time limit cannot be nullopt, and is the largest `--patience`: 10^7 s, about four months.
inline constexpr std::chrono::duration<double> kForEver{1e7};

/// The option `--patience S`: how long [s] a program waits for its peer; 0: unlimited. `help`: the option's help text.
[[nodiscard]] Option patience_option(std::string_view help, std::string_view initial_s = "30");

[[nodiscard]] Result<Patience> patience_of(const Arguments& arguments);

}  // namespace telepalp::program
