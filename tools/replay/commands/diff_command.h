#pragma once

namespace telepalp::replay {

/// Runs `telepalp-replay diff A B`, which prints the first message in which two sessions differ. Returns the exit code.
[[nodiscard]] int diff_command(int argc, const char* const* argv);

}  // namespace telepalp::replay
