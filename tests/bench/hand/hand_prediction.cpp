#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "haptic_station/tracking/hand_estimate.h"
#include "haptic_station/tracking/hand_trace.h"
#include "tests/bench/hand/studies.h"
#include "where.h"

// Recorded hands are predicted from their samples. The prediction must be at least as good as the straight line through
// the last two samples.

namespace telepalp::bench::hand {
namespace {

constexpr double kHorizons_s[] = {0.005, 0.01, 0.02, 0.03, 0.05};
constexpr double kTrackerLostHand_s = 0.05;  // greatest time between two samples for a prediction to count

/// The trace, interpolated between its samples.
std::optional<Eigen::Vector3d> hand_at(const std::vector<tracking::TraceSample>& samples, SessionTime when) {
  const auto after = std::lower_bound(samples.begin(), samples.end(), when,
                                      [](const tracking::TraceSample& one, SessionTime at) { return one.at < at; });
  if (after == samples.begin() || after == samples.end()) return std::nullopt;
  const auto before = after - 1;
  const double gap_s = to_seconds(after->at - before->at);
  if (gap_s > kTrackerLostHand_s) return std::nullopt;
  const double share = to_seconds(when - before->at) / gap_s;
  return before->palm.m + share * (after->palm.m - before->palm.m);
}

/// Ratio of the RMS errors of the estimate and of the straight line through the last two samples, for a prediction of
/// `ahead_s`.
double ratio_to_straight_on(const tracking::HandTrace& trace, std::size_t every, double ahead_s) {
  tracking::HandEstimate estimate;
  double estimate_square = 0.0;
  double line_square = 0.0;
  const tracking::TraceSample* last = nullptr;
  for (std::size_t i = 0; i < trace.samples.size(); i += every) {
    const tracking::TraceSample& sample = trace.samples[i];
    (void)estimate.update(sample.at, {sample.palm.m});
    const tracking::TraceSample* before = last;
    last = &sample;
    if (i < 5 * every || to_seconds(sample.at - before->at) > kTrackerLostHand_s) continue;
    const SessionTime when = sample.at + from_seconds(ahead_s);
    const auto truth = hand_at(trace.samples, when);
    if (!truth) continue;
    const Eigen::Vector3d speed = (sample.palm.m - before->palm.m) / to_seconds(sample.at - before->at);
    estimate_square += (estimate.predict(when).at.m - *truth).squaredNorm();
    line_square += (sample.palm.m + ahead_s * speed - *truth).squaredNorm();
  }
  return std::sqrt(estimate_square / line_square);
}

std::vector<Row> measure(const Options&) {
  std::vector<Row> rows;
  double log_sum = 0.0;
  int count = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(TELEPALP_SOURCE_DIR "/tests/data/hand_tracking"))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const Result<tracking::HandTrace> trace = tracking::read_hand_trace(file);
    for (const std::size_t every : {1U, 2U}) {
      double worst = trace ? 0.0 : NAN;
      for (const double ahead_s : kHorizons_s) {
        if (!trace) continue;
        const double ratio = ratio_to_straight_on(*trace, every, ahead_s);
        worst = std::max(worst, ratio);
        log_sum += std::log(ratio);
        ++count;
      }
      rows.push_back(at_most("prediction/" + file.stem().string() + (every == 1 ? ", full rate" : ", half rate") +
                                 ": error to straight-on, worst of 5-50 ms",
                             worst, "", 1.02));
    }
  }
  rows.push_back(
      at_most("prediction: error to straight-on, geometric mean", std::exp(log_sum / std::max(1, count)), "", 0.98));
  return rows;
}

}  // namespace

std::vector<Study> hand_prediction() { return {{"prediction", measure}}; }

}  // namespace telepalp::bench::hand
