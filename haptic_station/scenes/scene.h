#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/device/trial.h"
#include "haptic_station/effects/effect_bank.h"
#include "proto/words/result.h"

namespace telepalp::scenes {

/// The ultrasound probe that the hand holds: width and depth of its image.
struct Probe {
  double width_m = 0.06;
  double depth_m = 0.10;
};

/// A patient from a model file, in place of the one that a camera sees.
struct PatientModel {
  std::string file;  ///< PLY, OBJ or PCD; a relative path starts at the scene file's folder
  double unit_m = 1.0;
  std::optional<std::uint32_t> samples;  ///< points on a mesh; nullopt or 0: as many as the shape needs
  Eigen::Isometry3d haptic_from_model = Eigen::Isometry3d::Identity();
  bool flip_normals = false;
};

/// A layer of the scene: a solid inside the body.
struct SceneLayer {
  std::shared_ptr<const effects::SolidLayer> solid;  ///< shared with the layer's recipe and effect
  std::uint32_t effect = 0;                          ///< index of its recipe in Scene::effects
};

/// A checked scene in plain values. Nothing outside this room reads the file's message.
struct Scene {
  std::string name;
  std::string purpose;  ///< one sentence; may be empty
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  bool center_on_surface = false;  ///< H's origin moves to the skin; see placed() in placement.h
  Transform<HapticBase, HandTracker> haptic_from_tracker;
  std::string surface;                   ///< the setting of the surface; empty: the default
  std::optional<PatientModel> model;     ///< nullopt: the patient whom the camera sees
  std::vector<effects::Recipe> effects;  ///< core::build_effects() makes effects of them
  std::optional<Probe> probe;            ///< nullopt: the hand holds no probe
  control::ControlSettings control;
  device::Trial trial = device::Trial::IndentSeveralPoints;
  std::optional<std::filesystem::path> hand_trace;  ///< file of a recorded hand, which replaces the trial
  double trace_deepest_m = 0.04;                    ///< how far the recorded hand's lowest point is below H's origin
  std::string text;                                 ///< of the file, so that a journal can keep it
  std::vector<Error> warnings;                      ///< what is valid and yet hardly meant, such as a ball 5 m away

  /// The scene's layers, in the order of its effects, for pictures and meshes.
  [[nodiscard]] std::vector<SceneLayer> layers() const;
  /// The solids of layers().
  [[nodiscard]] std::vector<std::shared_ptr<const effects::SolidLayer>> solids() const;
  /// The recipe of the first skin; nullptr without a skin.
  [[nodiscard]] const effects::SkinSettings* skin() const noexcept;
};

/// The file of a scene: `scene` itself if it is a file, else the scene of this name in telepalp's library, such as
/// "skin". Error: `scene` is neither a file nor the name of a scene in the library.
[[nodiscard]] Result<std::filesystem::path> find_scene(const std::string& scene);

/// Reads and checks a *.scene.textproto and the files that its effects name. Error: an unknown field, reported with
/// line and column; a value out of its range, reported with field, unit and range; or an unreadable file.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& file);

/// How densely meshes are sampled: as the scene says, or twice as densely, with nodes 1 mm apart or more, to judge what
/// the scene's sampling costs in accuracy.
enum class MeshDetail { AsGiven, Finer };

/// Parses and checks the text of a scene file. `name`: the file's path, for errors and as the base of relative paths.
[[nodiscard]] Result<Scene> parse_scene(const std::string& text, const std::filesystem::path& name,
                                        MeshDetail detail = MeshDetail::AsGiven);

}  // namespace telepalp::scenes
