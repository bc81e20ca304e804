#include "tools/replay/words/shipped_scene.h"

#include "support/program/files/shipped.h"

namespace telepalp::replay {

Result<std::filesystem::path> scene_file(const std::string& scene) {
  std::error_code failed;
  if (std::filesystem::exists(scene, failed)) return std::filesystem::path(scene);
  if (scene.find('/') == std::string::npos)
    if (const auto shipped = program::shipped_file("haptic_station/scenes/" + scene + ".scene.textproto"))
      return *shipped;
  return Error{.what = "is neither a file nor a scene that ships",
               .where = "--scene " + scene,
               .fix = "give a *.scene.textproto, or a name such as skin or palpation"};
}

}  // namespace telepalp::replay
