#pragma once

#include <optional>
#include <vector>

#include "haptic_station/core/inside/inner_surfaces_stage.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/ultrasound/b_mode.h"

namespace telepalp::station {

/// The layers of a scene, for the core's stages.
[[nodiscard]] inline std::vector<core::InnerLayer> inner_layers(const scenes::Scene& scene) {
  std::vector<core::InnerLayer> layers;
  for (const scenes::SceneLayer& layer : scene.layers()) layers.push_back({layer.solid, layer.effect});
  return layers;
}

/// The image of a scene's probe; nullopt: the hand holds no probe.
[[nodiscard]] inline std::optional<ultrasound::BModeSettings> image_settings(const scenes::Scene& scene) {
  if (!scene.probe) return std::nullopt;
  return ultrasound::BModeSettings{.width_m = scene.probe->width_m, .depth_m = scene.probe->depth_m};
}

}  // namespace telepalp::station
