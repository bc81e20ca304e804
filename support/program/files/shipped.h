#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace telepalp::program {

/// Finds a file that is installed with telepalp, such as `haptic_station/scenes/palpation.scene.textproto`. It is
/// searched in $TELEPALP_HOME if that is set; otherwise in share/telepalp of the installation prefix, or in the
/// repository from which the program was built. The working directory has no effect. nullopt: not found.
[[nodiscard]] std::optional<std::filesystem::path> shipped_file(const std::filesystem::path& relative);

/// The path of another program of telepalp. All of them lie in one folder, in a build tree as in an installation.
[[nodiscard]] std::filesystem::path sibling_program(std::string_view name);

}  // namespace telepalp::program
