#pragma once

namespace telepalp::edge_plan {

/// The command `telepalp-link edges`; returns the exit code.
[[nodiscard]] int edges_command(int argc, const char* const* argv);

}  // namespace telepalp::edge_plan
