#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "haptic_station/scenes/scene.h"

namespace telepalp::station {

/// The computing time of one effect of a scene in one tick.
struct EffectPrice {
  std::string name;
  double mean_us = 0.0;     ///< median of the means of 20 parts of the path, so that another program does not raise it
  double largest_us = 0.0;  ///< largest cost of one tick
  std::size_t shapes = 0;   ///< of a layer's tree; 0: not a layer
  std::size_t bytes = 0;    ///< memory of that tree [B]
  std::string depth_error;  ///< error of the felt depth, in words: see docs/accuracy.md
};

/// The cost of each effect of the scene, measured over 10 s of virtual time, while the device presses up to 40 mm deep
/// all over a square of 0.24 m side of a level skin.
[[nodiscard]] std::vector<EffectPrice> price_of(const scenes::Scene& scene);

}  // namespace telepalp::station
