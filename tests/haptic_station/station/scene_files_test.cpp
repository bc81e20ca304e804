#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/scene_parts.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The names of the files in a folder that are opened while this object exists.
class OpenedFiles {
 public:
  explicit OpenedFiles(const fs::path& folder) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    EXPECT_GE(inotify_add_watch(queue_, folder.c_str(), IN_OPEN), 0);
  }
  ~OpenedFiles() { close(queue_); }
  OpenedFiles(const OpenedFiles&) = delete;
  OpenedFiles& operator=(const OpenedFiles&) = delete;

  [[nodiscard]] Names names() const {
    Names names;
    alignas(inotify_event) std::array<char, 1 << 16> bytes{};
    for (ssize_t size = 0; (size = read(queue_, bytes.data(), bytes.size())) > 0;)
      for (ssize_t at = 0; at < size;) {
        inotify_event event{};
        std::memcpy(&event, bytes.data() + at, sizeof event);
        if ((event.mask & IN_ISDIR) == 0 && event.len > 0) names.insert(bytes.data() + at + sizeof event);
        at += static_cast<ssize_t>(sizeof event + event.len);
      }
    return names;
  }

 private:
  int queue_;
};

/// A closed mesh that is read in an instant: a tetrahedron, 0.2 m wide.
constexpr const char* kMesh = "v 0 0 0\nv 0.2 0 0\nv 0 0.2 0\nv 0 0 0.2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A copy of the scenes, beside meshes of which some scenes name one or two.
class SceneFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::copy(TELEPALP_SOURCE_DIR "/haptic_station/scenes", folder_.path());
    for (const char* mesh : {"liver.obj", "spleen.obj", "body.obj"}) write(mesh, kMesh);
    const std::string skin = "haptic_from_camera { translation_m { y: 0.8 } } effects { skin {} } ";
    write("mine.scene.textproto", skin +
                                      "effects { organ { file: \"liver.obj\" cell_m: 0.02 } } "
                                      "patient_surface { static_model { file: \"body.obj\" samples: 500 } }");
    write("layer.scene.textproto", skin + "effects { solid { name: \"spleen\" polish: \"mesh spleen.obj 1 0.02\" } }");
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }
  [[nodiscard]] fs::path file(const std::string& scene) const { return folder_.path() / (scene + ".scene.textproto"); }
  support::TemporaryFolder folder_;
};

TEST_F(SceneFiles, TheStationOpensOnlyTheFilesThatItsSceneNames) {
  const std::pair<const char*, Names> kOpened[] = {{"skin", {}},
                                                   {"palpation", {}},
                                                   {"ribs-ultrasound", {}},
                                                   {"layer", {"spleen.obj"}},
                                                   {"mine", {"liver.obj", "body.obj"}}};
  for (const auto& [name, data] : kOpened) {
    const OpenedFiles opened(folder_.path());
    const Result<scenes::Scene> scene = scenes::read_scene(file(name));
    ASSERT_TRUE(scene.ok()) << to_string(scene.error());
    const Result<SceneParts> parts = read_parts(*scene, file(name), true);
    ASSERT_TRUE(parts.ok()) << to_string(parts.error());
    Names expected = data;
    expected.insert(file(name).filename().string());
    EXPECT_EQ(opened.names(), expected) << name;
  }
}

TEST_F(SceneFiles, ASceneStartsWithoutTheDataThatItDoesNotName) {
  for (const char* mesh : {"liver.obj", "spleen.obj", "body.obj"}) fs::remove(folder_.path() / mesh);
  EXPECT_TRUE(scenes::read_scene(file("skin")).ok());
  for (const std::string name : {"layer", "mine"}) {
    const Result<scenes::Scene> scene = scenes::read_scene(file(name));
    ASSERT_FALSE(scene.ok()) << name;
    EXPECT_TRUE(scene.error().where.starts_with(file(name).string() + ":1:")) << scene.error().where;
    EXPECT_NE(scene.error().what.find(".obj: cannot be read"), std::string::npos) << scene.error().what;
  }
}

}  // namespace
}  // namespace telepalp::station
