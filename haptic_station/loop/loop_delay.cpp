#include "haptic_station/loop/loop_delay.h"

#include <algorithm>
#include <cmath>

namespace telepalp::loop {
namespace {

constexpr std::uint16_t kInASecond = 2000;
constexpr std::uint16_t kRenewedEvery = 100;
constexpr double kSilent_s = 0.005;
constexpr double kQuantile = 0.99;

}  // namespace

void LoopDelay::add(const ports::DeviceReading& reading) noexcept {
  if (!reading.loop_s || !(*reading.loop_s >= 0.0) || !std::isfinite(*reading.loop_s)) return;
  if (!(reading.age_s < kSilent_s)) return;
  const auto bin = static_cast<std::size_t>(std::min(*reading.loop_s / kBin_s, static_cast<double>(kBins - 1)));
  ++now_.count[bin];
  now_.longest_s[bin] = std::max(now_.longest_s[bin], static_cast<float>(*reading.loop_s));
  if (++now_.all % kRenewedEvery == 0) p99_s_ = quantile_s();
  if (now_.all < kInASecond) return;
  before_ = now_;
  now_ = {};
}

double LoopDelay::quantile_s() const noexcept {
  const int below = static_cast<int>((1.0 - kQuantile) * (now_.all + before_.all));  // readings above quantile
  int longer = 0;
  for (std::size_t bin = kBins; bin-- > 0;) {
    longer += now_.count[bin] + before_.count[bin];
    if (longer > below) return static_cast<double>(std::max(now_.longest_s[bin], before_.longest_s[bin]));
  }
  return 0.0;
}

}  // namespace telepalp::loop
