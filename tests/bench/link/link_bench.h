#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// Frames over impaired paths: telepalp's sealed datagrams beside plain UDP, plain TCP and, where it is installed, SRT.
/// All but SRT run in virtual time.
[[nodiscard]] Result<Report> run_link(const program::Arguments& arguments);

}  // namespace telepalp::bench
