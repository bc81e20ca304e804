#pragma once

#include <Eigen/Core>
#include <string_view>
#include <variant>

#include "proto/words/result.h"

namespace telepalp::study {

/// The person wants the next penetration.
struct BeginPenetration {};
/// The hand goes on along the handle's path by this distance [m].
struct PushHand {
  double by_m = 0.0;
};
/// The hand moves by this vector in the plane of the linkage [m].
struct MoveHand {
  Eigen::Vector2d by_m;
};
/// The person lets go: Escape, or the page is no longer in front.
struct LetGo {};

/// What the page of the protocol asks of the program.
using PageCommand = std::variant<BeginPenetration, PushHand, MoveHand, LetGo>;

inline constexpr std::size_t kMostPageCommandBytes = 128;

/// Reads a message of the page: `begin`, `push 0.5`, `move 1.5 -2` (mm), `stop`. Error: another word, or a number that
/// is not finite or over 1000 mm.
[[nodiscard]] Result<PageCommand> parse_page_command(std::string_view message);

}  // namespace telepalp::study
