#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {

/// The one-way delays that some studies compare [s].
inline constexpr std::array kDelays_s{0.05, 0.1, 0.2};
using OfDelays = std::array<double, kDelays_s.size()>;
inline constexpr double kJitter_s = 0.03;

/// Name of the delay at index `delay` of kDelays_s: "50 ms".
[[nodiscard]] std::string delay_name(std::size_t delay);

/// The feed's link, which stations with different delays share: jitter, losses and a one-way delay of kJitter_s. Each
/// station adds the rest of its own delay.
[[nodiscard]] Link link_before_delays(double loss = 0.1) noexcept;

/// One of several stations on one feed.
struct DelayedStation {
  BenchStation station;
  std::size_t delay;  ///< index in kDelays_s
};

/// A station for each anchor and delay: all delays of the first anchor, then all of the second. They do not limit
/// the force when the motors are warm: a hand that holds a force for long would reach this limit, which is no error of
/// the skin.
[[nodiscard]] std::vector<DelayedStation> stations_at_delays(const Transform<HapticBase, DepthCamera>& placed,
                                                             const std::function<std::unique_ptr<Person>()>& person);

/// Runs all stations on `feed`, whose link is link_before_delays(), for `seconds`. Calls `judge` with each station's
/// index after each of its ticks.
void run_together(Feed& feed, std::span<DelayedStation> stations, double seconds,
                  const std::function<void(std::size_t index, const Tick& tick)>& judge);

/// Force [N] in H of an ideal display of the image that the station touches in `tick`: the force law on the true skin
/// as it was when this image was captured, without an anchor.
[[nodiscard]] Eigen::Vector3d newest_image_N(const Feed& feed, const Tick& tick,
                                             const Transform<HapticBase, DepthCamera>& placed);

}  // namespace telepalp::bench::hand
