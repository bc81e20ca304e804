#include "haptic_station/surface/build/setting_choice.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

constexpr double kShare = 0.5;        // share of the frame period that a snapshot may take
constexpr double kSpareShare = 0.15;  // below this share the next better setting fits: it costs three times as much
constexpr double kPatience_s = 0.33;
constexpr double kFirstRetry_s = 10.0;
constexpr double kLongestRetry_s = 600.0;

SurfaceSettings with_step(SurfaceSettings settings, int step_px) {
  settings.node_step_px = step_px;
  settings.name += ", nodes every " + std::to_string(step_px) + " px";
  return settings;
}

SurfaceSettings with_index(SurfaceSettings settings, Index index, const char* name) {
  settings.index = index;
  settings.name = name;
  return settings;
}

}  // namespace

std::vector<SurfaceSettings> affordable_settings(const SurfaceSettings& asked) {
  if (asked.method == Method::Grid)
    return {asked, with_step(asked, asked.node_step_px + 1), with_step(asked, 2 * asked.node_step_px)};
  if (asked.method == Method::Paper && asked.index == Index::PclKdTree)
    return {asked, with_index(asked, Index::PclOrganized, "paper-organized")};
  return {asked};
}

bool SettingChoice::add(double cost_s, double frame_s) noexcept {
  over_s_ = cost_s > kShare * frame_s ? over_s_ + frame_s : std::max(0.0, over_s_ - frame_s);
  within_s_ = cost_s < kSpareShare * frame_s ? within_s_ + frame_s : 0.0;
  if (over_s_ > kPatience_s && chosen_ + 1 < settings_.size()) {
    ++chosen_;
    retry_after_s_ = std::clamp(2.0 * retry_after_s_, kFirstRetry_s, kLongestRetry_s);
  } else if (within_s_ > retry_after_s_ && chosen_ > 0) {
    --chosen_;
  } else {
    return false;
  }
  over_s_ = within_s_ = 0.0;
  return true;
}

}  // namespace telepalp::surface
