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
///
/// The model is that of the place at which the tool will be when the model is displayed, if its velocity stays. The
/// direction of the force turns with the prism: a model of where the tool was 20 ms ago errs by 3 % of the force at
/// 0.1 m/s, whatever the accuracy of its step.
class PrismStage {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(16);

  explicit PrismStage(const effects::FemPrismSettings& settings);
  ~PrismStage();
  /// The first call prepares the prism, which takes as long as some steps.
  /// nullopt: the settings have no prism, or its motion diverged and begins again at rest.
  [[nodiscard]] std::optional<tissue::LocalPlane> model_at(const ModelWanted& wanted);

 private:
  [[nodiscard]] Eigen::Vector3d expected_m(const ModelWanted& wanted);

  std::shared_ptr<const tissue::PrismModel> model_;  // shared with the recipe; nullptr: no prism
  std::unique_ptr<tissue::PrismTouch> touch_;        // nullptr: before the first call
  std::optional<ModelWanted> last_;                  // of the last call
};

template <>
struct SlowStageOf<effects::FemPrism> {
  using Stage = PrismStage;
};

}  // namespace telepalp::core
