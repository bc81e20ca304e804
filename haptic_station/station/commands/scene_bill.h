#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"

namespace telepalp::station {

/// The computing time of one effect of a scene in one tick, measured by price_of().
struct EffectPrice {
  std::string name;
  double mean_us = 0.0;     ///< median of the means of 20 parts of 0.5 s, so that other programs do not raise it
  double largest_us = 0.0;  ///< largest cost of one tick
  std::size_t shapes = 0;   ///< number of shapes of a layer; 0: not a layer
  std::size_t bytes = 0;    ///< memory of the layer's SolidTree [B]
  std::string depth_error;  ///< error of the depth at which the effect is felt, as text; see docs/accuracy.md
};

/// The cost of each effect of the scene, in the scene's order, over 10 s of virtual time, in which the device presses
/// up to 40 mm deep into a level skin, all over a square of 0.24 m side.
[[nodiscard]] std::vector<EffectPrice> price_of(const scenes::Scene& scene);

}  // namespace telepalp::station
