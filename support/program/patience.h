#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "support/program/options.h"

namespace telepalp::program {

using Patience = std::optional<std::chrono::duration<double>>;  ///< time limit; nullopt: unlimited

/// Replaces "unlimited" where a number is needed: about four months.
inline constexpr std::chrono::duration<double> kForEver{1e7};

/// The option `--patience S`: how long a program waits for its peer. `help`: the option's help text.
[[nodiscard]] Option patience_option(std::string_view help, std::string_view initial_s = "30");

[[nodiscard]] Result<Patience> patience_of(const Arguments& arguments);

}  // namespace telepalp::program
