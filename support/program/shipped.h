#pragma once

#include <filesystem>
#include <optional>

namespace telepalp::program {

/// A file that comes with telepalp, such as `haptic_station/scenes/palpation.scene.textproto`: below $TELEPALP_HOME
/// when that is set, else below the nearest folder above the running program that holds it (the repository, or an
/// installation laid out like it). nullopt when there is none.
[[nodiscard]] std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& relative);

}  // namespace telepalp::program
