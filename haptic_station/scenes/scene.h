#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/device/trial.h"
#include "haptic_station/effects/effect_bank.h"
#include "messages/scene.pb.h"
#include "proto/words/result.h"
#include "support/program/text_format.h"

namespace telepalp::scenes {

/// The ultrasound probe that the hand holds: width and depth of its image.
struct Probe {
  double width_m = 0.06;
  double depth_m = 0.10;
};

/// A layer of the scene: a solid inside the body.
struct SceneLayer {
  std::shared_ptr<const effects::SolidLayer> solid;  ///< shared with the layer's effect
  std::uint32_t effect = 0;                          ///< index of this effect in Scene::effects
};

/// The lattice of signed distances of an organ effect.
struct SceneOrgan {
  std::shared_ptr<const solids::DistanceLattice> shape;  ///< shared with the organ's effect
  std::uint32_t effect = 0;                              ///< index of this effect in Scene::effects
};

/// A checked scene in plain values. `message`: the parsed file; message.surface() names the setting of the surface.
struct Scene {
  std::string name;
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  bool center_on_surface = false;  ///< H's origin moves to the skin; see placed() in placement.h
  Transform<HapticBase, HandTracker> haptic_from_tracker;
  effects::EffectBank effects;
  std::vector<SceneLayer> layers;  ///< of the solid effects, for pictures and meshes
  std::vector<SceneOrgan> organs;  ///< of the organ effects, for pictures
  std::optional<Probe> probe;      ///< nullopt: the hand holds no probe
  control::ControlSettings control;
  device::SimulatedDeviceSettings simulated_device;
  device::SimulatedHandSettings simulated_hand;
  device::Trial trial = device::Trial::IndentSeveralPoints;
  std::optional<std::filesystem::path> hand_trace;  ///< file of a recorded hand, which replaces the trial
  double trace_deepest_m = 0.04;                    ///< how far the recorded hand's lowest point is below H's origin
  msg::Scene message;
  std::vector<Error> warnings;  ///< what is valid and yet hardly meant, such as a ball 5 m away

  /// The solids of `layers`.
  [[nodiscard]] std::vector<std::shared_ptr<const effects::SolidLayer>> solids() const;
};

/// The file of a scene: `scene` itself if it is a file, else the scene of this name in telepalp's library, such as
/// "skin". Error: `scene` is neither a file nor the name of a scene in the library.
[[nodiscard]] Result<std::filesystem::path> find_scene(const std::string& scene);

/// Reads and checks a *.scene.textproto and the files that its effects name. Error: an unknown field, reported with
/// line and column; a value out of its range, reported with field, unit and range; or an unreadable file.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& file);

/// Parses and checks the text of a scene file. `name`: the file's path, for errors and as the base of relative paths.
[[nodiscard]] Result<Scene> parse_scene(const std::string& text, const std::filesystem::path& name);

/// Checks a message and converts it to plain values. `places`: position of each number in the file, for errors.
[[nodiscard]] Result<Scene> make_scene(const msg::Scene& message, const std::filesystem::path& name,
                                       const program::NumberPlaces& places = program::NumberPlaces());

}  // namespace telepalp::scenes
