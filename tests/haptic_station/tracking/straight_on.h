#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "haptic_station/device/random.h"
#include "haptic_station/tracking/hand_estimate.h"
#include "haptic_station/tracking/hand_trace.h"
#include "where.h"

namespace telepalp::testing {

/// The horizons at which predictions are judged.
inline constexpr double kHorizons_s[] = {0.005, 0.01, 0.02, 0.03, 0.05};

/// The recorded hands that tests read, sorted by name.
inline std::vector<std::filesystem::path> recorded_hands() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TELEPALP_SOURCE_DIR "/tests/data/hand_tracking"))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The trace between its samples; nullopt where the tracker lost the hand.
inline std::optional<Eigen::Vector3d> hand_at(const std::vector<tracking::TraceSample>& samples, SessionTime when,
                                              double lost_after_s) {
  const auto after = std::lower_bound(samples.begin(), samples.end(), when,
                                      [](const tracking::TraceSample& one, SessionTime at) { return one.at < at; });
  if (after == samples.begin() || after == samples.end()) return std::nullopt;
  const auto before = after - 1;
  const double gap_s = to_seconds(after->at - before->at);
  if (gap_s > lost_after_s) return std::nullopt;
  const double share = to_seconds(when - before->at) / gap_s;
  return before->palm.m + share * (after->palm.m - before->palm.m);
}

/// RMS error of HandEstimate over that of the straight line through the last two samples, `ahead_s` ahead, when each
/// `every`-th sample of the trace is measured with white noise of `noise_m` a axis. The truth is the trace itself.
inline double ratio_to_straight_on(const tracking::HandTrace& trace, std::size_t every, double ahead_s,
                                   double noise_m = 0.0) {
  constexpr double kLost_s = 0.05;
  device::Random random(17);
  tracking::HandEstimate estimate;
  double estimate_square = 0.0;
  double line_square = 0.0;
  std::optional<tracking::TraceSample> last;
  for (std::size_t i = 0; i < trace.samples.size(); i += every) {
    tracking::TraceSample sample = trace.samples[i];
    if (noise_m > 0.0) sample.palm.m += noise_m * Eigen::Vector3d{random.normal(), random.normal(), random.normal()};
    (void)estimate.update(sample.at, {sample.palm.m});
    const std::optional<tracking::TraceSample> before = last;
    last = sample;
    if (i < 5 * every || to_seconds(sample.at - before->at) > kLost_s) continue;
    const SessionTime when = sample.at + from_seconds(ahead_s);
    const auto truth = hand_at(trace.samples, when, kLost_s);
    if (!truth) continue;
    const Eigen::Vector3d speed = (sample.palm.m - before->palm.m) / to_seconds(sample.at - before->at);
    estimate_square += (estimate.predict(when).at.m - *truth).squaredNorm();
    line_square += (sample.palm.m + ahead_s * speed - *truth).squaredNorm();
  }
  return std::sqrt(estimate_square / line_square);
}

/// The worst ratio of any horizon.
inline double worst_ratio_to_straight_on(const tracking::HandTrace& trace, std::size_t every, double noise_m = 0.0) {
  double worst = 0.0;
  for (const double ahead_s : kHorizons_s)
    worst = std::max(worst, ratio_to_straight_on(trace, every, ahead_s, noise_m));
  return worst;
}

}  // namespace telepalp::testing
