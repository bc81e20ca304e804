#pragma once

namespace telepalp::replay {

/// `telepalp-replay diff A B`.
[[nodiscard]] int diff_command(int argc, const char* const* argv);

}  // namespace telepalp::replay
