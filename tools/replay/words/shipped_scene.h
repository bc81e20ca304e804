#pragma once

#include <filesystem>
#include <string>

#include "proto/words/result.h"

namespace telepalp::replay {

/// The file of a scene: `scene` itself if it is a file, else the scene of this name that ships ("skin"). Error:
/// neither.
[[nodiscard]] Result<std::filesystem::path> scene_file(const std::string& scene);

}  // namespace telepalp::replay
