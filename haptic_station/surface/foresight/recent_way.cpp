#include "haptic_station/surface/foresight/recent_way.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

constexpr double kWayWindow_s = 0.5;
constexpr double kLivedPerFreeze = 1.5;   // a prediction that stops at twice the age has then lived 1.5 times this age
constexpr double kSlow_m_per_s = 1e-4;    // a slower prediction goes nowhere
constexpr double kShortestStop_s = 1e-3;  // a prediction needs some time to stop

}  // namespace

void RecentWay::add(std::span<const float> displacement_m, std::span<const float> weight, double dt_s) {
  now_s_ += dt_s;
  past_.push_back({now_s_, {displacement_m.begin(), displacement_m.end()}});
  while (now_s_ - past_.front().at_s > kWayWindow_s) past_.pop_front();
  m_ = 0.0;
  for (const Past& past : past_) {
    double square_m2 = 0.0;
    double sum = 1e-30;
    for (std::size_t i = 0; i < displacement_m.size(); ++i) {
      const auto went_m = static_cast<double>(displacement_m[i] - past.displacement_m[i]);
      square_m2 += static_cast<double>(weight[i]) * went_m * went_m;
      sum += static_cast<double>(weight[i]);
    }
    m_ = std::max(m_, std::sqrt(square_m2 / sum));
  }
}

double freeze_within(double way_m, double speed_m_per_s, double longest_s) noexcept {
  const double most_s = way_m / (kLivedPerFreeze * std::max(speed_m_per_s, kSlow_m_per_s));
  return std::clamp(most_s, kShortestStop_s, longest_s);
}

}  // namespace telepalp::surface
