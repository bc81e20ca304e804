#include <cmath>
#include <numbers>
#include <string>

#include "tests/bench/mixed/section.h"
#include "tests/clients/mixed/anchored_headset.h"
#include "tests/tools/study/ideal_observer.h"

namespace telepalp::bench {
namespace {

using namespace mixed;
using namespace study;

void add_anchor_rows(std::vector<Row>& rows) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr int kSeeds = 2000;
  // The device's base is level and the headset knows gravity, so that three touches give heading and place.
  const auto add = [&](const std::string& what, int repeats, double at_mm, double turn_deg) {
    const AnchorError level = anchor_error(0.2, repeats, Gravity::Known, kSeeds);
    const AnchorError any = anchor_error(0.2, repeats, Gravity::Unknown, kSeeds);
    const std::string start = "headset, " + what + ", sides 20 cm: ";
    rows.push_back(at_most(start + "patient seen against felt, rms", level.at_m * 1e3, "mm", at_mm));
    rows.push_back(at_most(start + "turn, rms", level.turn_rad / kDegree, "deg", turn_deg));
    rows.push_back(measured(start + "gravity unknown: patient seen against felt, rms", any.at_m * 1e3, "mm"));
    rows.push_back(measured(start + "gravity unknown: turn, rms", any.turn_rad / kDegree, "deg"));
  };
  add("three touches", 1, 1.4, 0.65);
  add("five touches a point", 5, 0.6, 0.3);
}

void add_thresholds(std::vector<Row>& rows, const std::string& name, const FoundThresholds& found, bool judged) {
  const std::string start = "threshold, " + name + ", 200 observers: ";
  if (judged)
    rows.push_back(at_most(start + "mean off the truth", 100.0 * std::abs(found.mean - 1.0), "%", 5.0));
  else
    rows.push_back(measured(start + "mean off the truth", 100.0 * std::abs(found.mean - 1.0), "%"));
  rows.push_back(measured(start + "standard deviation", 100.0 * found.deviation, "%"));
  rows.push_back(measured(start + "runs within 10 %", 100.0 * found.within_tenth, "%"));
  rows.push_back(measured(start + "trials", found.trials, ""));
}

}  // namespace

std::vector<Row> run_anchor_section() {
  std::vector<Row> rows;
  add_anchor_rows(rows);
  add_thresholds(rows, "staircase of 24 reversals", staircase_thresholds(0.3, {}, kStaircaseTarget, 200), true);
  add_thresholds(rows, "equal steps taken for 79.4 %", staircase_thresholds(0.3, {.down_by_up = 1.0}, 0.794, 200),
                 false);
  add_thresholds(rows, "QUEST of 100 trials", quest_thresholds(0.3, 100, 200), true);
  return rows;
}

}  // namespace telepalp::bench
