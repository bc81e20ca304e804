#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "haptic_station/control/values/encountered_settings.h"
#include "haptic_station/device/simulated_pair.h"
#include "haptic_station/device/trial.h"
#include "haptic_station/effects/effect_bank.h"
#include "messages/scene.pb.h"
#include "proto/words/result.h"
#include "support/program/text_format.h"

namespace telepalp::scenes {

/// A scene, checked and in plain values. `message` is the file as read, for what other parts read of it
/// (`surface()`), and for recording.
struct Scene {
  std::string name;
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  bool center_on_surface = false;
  Transform<HapticBase, HandTracker> haptic_from_tracker;
  effects::EffectBank effects;
  control::ControlSettings control;
  device::SimulatedDeviceSettings simulated_device;
  device::SimulatedHandSettings simulated_hand;
  device::Trial trial = device::Trial::IndentSeveralPoints;
  std::optional<std::filesystem::path> hand_trace;  ///< instead of the trial, resolved against the scene's folder
  double trace_deepest_m = 0.04;
  msg::Scene message;
};

/// Reads and checks a *.scene.textproto. An unknown field is an error with line and column; a value out of its range
/// one with the field's name, its unit and the range.
[[nodiscard]] Result<Scene> read_scene(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in errors, and its folder resolves relative paths.
[[nodiscard]] Result<Scene> parse_scene(const std::string& text, const std::filesystem::path& name);

/// Checks a message and turns it into plain values.
/// `places`: where its numbers stand in the file, for errors.
[[nodiscard]] Result<Scene> make_scene(const msg::Scene& message, const std::filesystem::path& name,
                                       const program::NumberPlaces& places = program::NumberPlaces());

}  // namespace telepalp::scenes
