#pragma once

#include <chrono>
#include <optional>
#include <string_view>

#include "support/program/options.h"

namespace telepalp::program {

using Patience = std::optional<std::chrono::duration<double>>;  ///< nullopt: for ever

/// What stands for it where a number is needed: four months.
inline constexpr std::chrono::duration<double> kForEver{1e7};

/// `--patience S`: how long a program that connects waits for its peer. `help` tells what it waits for.
[[nodiscard]] Option patience_option(std::string_view help, std::string_view initial_s = "30");

[[nodiscard]] Result<Patience> patience_of(const Arguments& arguments);

}  // namespace telepalp::program
