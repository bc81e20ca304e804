#include "haptic_station/surface/foresight/recent_mean.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

constexpr double kMeanWindow_s = 2.0;
constexpr double kShortestFrame_s = 1e-3;  // two frames of one instant count, too

}  // namespace

void RecentMean::add(std::span<const float> displacement_m, double dt_s) {
  past_.push_back({std::clamp(dt_s, kShortestFrame_s, kMeanWindow_s), {displacement_m.begin(), displacement_m.end()}});
  const auto count = [&](const Past& past, double sign) {
    lasts_s_ += sign * past.lasts_s;
    for (std::size_t i = 0; i < sum_m_s_.size(); ++i)
      sum_m_s_[i] += sign * past.lasts_s * static_cast<double>(past.displacement_m[i]);
  };
  count(past_.back(), 1.0);
  while (past_.size() > 1 && lasts_s_ > kMeanWindow_s) {
    count(past_.front(), -1.0);
    past_.pop_front();
  }
}

}  // namespace telepalp::surface
