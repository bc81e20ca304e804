#pragma once

#include <memory>
#include <optional>

#include "haptic_station/core/effect_stage.h"
#include "haptic_station/effects/effect_bank.h"
#include "haptic_station/tissue/fem/prism_model.h"
#include "haptic_station/tissue/fem/prism_touch.h"

namespace telepalp::core {

/// The slow stage of the effect FemPrism: one step of the prism in each run. A run that is late makes the prism's time
/// pass more slowly; its shape in equilibrium is the same.
class PrismStage {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(16);

  explicit PrismStage(const effects::FemPrismSettings& settings);
  ~PrismStage();
  /// The first call prepares the prism, which takes as long as some steps.
  /// nullopt: the settings have no prism, or its motion diverged and begins again at rest.
  [[nodiscard]] std::optional<tissue::LocalPlane> model_at(const ToolAt& tool);

 private:
  std::shared_ptr<const tissue::PrismModel> model_;  // shared with the recipe; nullptr: no prism
  std::unique_ptr<tissue::PrismTouch> touch_;        // nullptr: before the first call
};

template <>
struct SlowStageOf<effects::FemPrism> {
  using Stage = PrismStage;
};

}  // namespace telepalp::core
