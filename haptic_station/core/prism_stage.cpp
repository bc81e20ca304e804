#include "haptic_station/core/prism_stage.h"

#include "haptic_station/tissue/fem/prism_touch.h"

namespace telepalp::core {

PrismStage::PrismStage(const effects::FemPrismSettings& settings) : model_(settings.model) {}

PrismStage::~PrismStage() = default;

std::optional<tissue::LocalPlane> PrismStage::model_at(const ToolAt& tool) {
  if (!model_) return std::nullopt;
  if (!touch_) touch_ = std::make_unique<tissue::PrismTouch>(model_);
  return touch_->step(tool.device.m, to_seconds(kPeriod));
}

}  // namespace telepalp::core
