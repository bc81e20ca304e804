#pragma once

#include <memory>
#include <vector>

#include "haptic_station/core/effect_stage.h"
#include "haptic_station/core/virtual_driver.h"

namespace telepalp::core {

/// Drives the slow stages of a scene's effects in virtual time. Owner: one thread.
class VirtualEffects {
 public:
  explicit VirtualEffects(std::vector<std::unique_ptr<EffectStage>> stages) {
    for (std::unique_ptr<EffectStage>& stage : stages) driven_.push_back({std::move(stage), {}});
  }

  /// Call it before each tick. `cost`: of each run of a stage.
  void advance(SessionTime now, const ToolAt& tool, Nanoseconds cost) {
    for (auto& [stage, driver] : driven_) {
      if (auto result = driver.finished(now)) stage->hand_over(std::move(*result));
      driver.begin(
          now, *stage, [cost](StageStep) { return cost; }, tool);
    }
  }
  [[nodiscard]] bool empty() const noexcept { return driven_.empty(); }

 private:
  struct Driven {
    std::unique_ptr<EffectStage> stage;
    VirtualDriver<EffectStage> driver;
  };
  std::vector<Driven> driven_;
};

}  // namespace telepalp::core
