#pragma once

#include "tests/bench/benches.h"

namespace telepalp::bench {

/// All figures that are asked of the link: frames over impaired paths, telepalp's sealed datagrams beside plain UDP,
/// plain TCP and, where it is installed, SRT; camera to hand; the session clock; subscribers. Paths and clock run in
/// virtual time, SRT and the rest in real time.
[[nodiscard]] Result<Report> run_link(const program::Arguments& arguments);

}  // namespace telepalp::bench
