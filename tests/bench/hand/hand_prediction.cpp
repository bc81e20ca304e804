#include <cmath>

#include "tests/bench/hand/studies.h"
#include "tests/haptic_station/tracking/straight_on.h"

// Recorded hands are predicted from their samples. The prediction must be at least as good as the straight line through
// the last two samples.

namespace telepalp::bench::hand {
namespace {

std::vector<Row> measure_hand_prediction(const Options&) {
  std::vector<Row> rows;
  double log_sum = 0.0;
  int count = 0;
  for (const auto& file : testing::recorded_hands()) {
    const Result<tracking::HandTrace> trace = tracking::read_hand_trace(file);
    for (const std::size_t every : {1U, 2U}) {
      double worst = trace ? 0.0 : NAN;
      for (const double ahead_s : testing::kHorizons_s) {
        if (!trace) continue;
        const double ratio = testing::ratio_to_straight_on(*trace, every, ahead_s);
        worst = std::max(worst, ratio);
        log_sum += std::log(ratio);
        ++count;
      }
      rows.push_back(
          at_most("prediction/" + file.stem().string() + (every == 1 ? ", full rate" : ", half rate") +
                      ": error of the predicted hand, divided by that of a straight line, worst of 5 to 50 ms ahead",
                  worst, "", 1.02));
    }
  }
  rows.push_back(at_most("prediction: error of the predicted hand, divided by that of a straight line, geometric mean",
                         std::exp(log_sum / std::max(1, count)), "", 0.98));
  return rows;
}

}  // namespace

std::vector<Study> hand_prediction() { return {{"prediction", measure_hand_prediction}}; }

}  // namespace telepalp::bench::hand
