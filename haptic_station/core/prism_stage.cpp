#include "haptic_station/core/prism_stage.h"

#include <algorithm>
#include <utility>

#include "haptic_station/tissue/fem/prism_touch.h"

namespace telepalp::core {

PrismStage::PrismStage(const effects::FemPrismSettings& settings) : model_(settings.model) {}

PrismStage::~PrismStage() = default;

/// Where the tool is expected in the middle of the time in which the model is displayed [m], by its velocity since the
/// last run. A tool that jumped, or that was not seen for long, is expected where it is.
Eigen::Vector3d PrismStage::expected_m(const ModelWanted& wanted) {
  constexpr double kLongAgo_s = 0.1;
  constexpr double kMostAhead_s = 0.032;
  constexpr double kMostAhead_m = 0.008;
  const std::optional<ModelWanted> last = std::exchange(last_, wanted);
  const Eigen::Vector3d& at_m = wanted.tool.device.m;
  if (!last) return at_m;
  const double since_s = to_seconds(wanted.begun - last->begun);
  if (!(since_s > 0.0 && since_s <= kLongAgo_s)) return at_m;
  const double ahead_s = std::clamp(to_seconds(wanted.displayed_in), 0.0, kMostAhead_s);
  const Eigen::Vector3d ahead_m = ahead_s / since_s * (at_m - last->tool.device.m);
  return ahead_m.norm() <= kMostAhead_m ? Eigen::Vector3d(at_m + ahead_m) : at_m;
}

std::optional<tissue::LocalPlane> PrismStage::model_at(const ModelWanted& wanted) {
  if (!model_) return std::nullopt;
  if (!touch_) touch_ = std::make_unique<tissue::PrismTouch>(model_);
  return touch_->step(expected_m(wanted), to_seconds(kPeriod));
}

}  // namespace telepalp::core
