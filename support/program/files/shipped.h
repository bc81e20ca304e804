#pragma once

#include <filesystem>
#include <optional>

namespace telepalp::program {

/// Finds a file that is installed with telepalp, such as `haptic_station/scenes/palpation.scene.textproto`. It is
/// searched in $TELEPALP_HOME if that is set; otherwise in share/telepalp of the installation prefix, or in the
/// repository from which the program was built. The working directory has no effect. nullopt: not found.
[[nodiscard]] std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& relative);

}  // namespace telepalp::program
