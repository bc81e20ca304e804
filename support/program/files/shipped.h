#pragma once

#include <filesystem>
#include <optional>

namespace telepalp::program {

/// Finds a file that comes with telepalp, such as `haptic_station/scenes/palpation.scene.textproto`: below
/// $TELEPALP_HOME when that is set; else in share/telepalp of the installation prefix, or in the repository that the
/// running program was built from. The working directory never matters. nullopt: no such file.
[[nodiscard]] std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& relative);

}  // namespace telepalp::program
