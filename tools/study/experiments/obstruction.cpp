#include "tools/study/experiments/obstruction.h"

#include <array>
#include <optional>

#include "proto/words/numbers/fixed_text.h"

namespace telepalp::study {
namespace {

constexpr int kMoves = 6;          // S3 8.3
constexpr int kTrainingMoves = 2;  // not compared, as in S3

enum Value : std::size_t { kToBlue, kSeconds, kPath_m, kDone };  // of a row, in the order of its columns

constexpr Drawn<Pusher> kPushers[] = {
    {"speed of the hand", "m/s", &Pusher::hand_m_per_s, 0.02, 0.045,
     "S3 8.3: mean speeds 28.5 ± 11.3 and 29.0 ± 6.2 mm/s. So the times' size is taken from S3, not predicted"},
    {"reaction time", "s", &Pusher::reaction_s, 0.12, 0.25, "as the operators of the needle's study"},
    {"unsteadiness of the hand", "of its speed", &Pusher::unsteady, 0.1, 0.3, "assumed: no source was found"},
    {"distance kept from a device in sight", "m", &Pusher::clearance_m, 0.0, 0.02, "assumed: no source was found"},
    {"share of the detour that is made", "", &Pusher::heeds, 0.0, 1.0,
     "assumed: S3 says that people avoid the device, not how much. It alone makes the groups differ"},
    {"slowness of the first move", "of the speed", &Pusher::slow_at_first, 0.2, 0.5,
     "assumed; S3 saw a clear training effect in the first two moves"},
};

constexpr Drawn<PushDesk> kDesks[] = {
    {"distance of the pockets", "m", &PushDesk::pockets_m, 0.14, 0.2, "not in S3; the Omni's workspace is 160 mm wide"},
    {"radius of a pocket", "m", &PushDesk::pocket_m, 0.015, 0.025, "not in S3"},
    {"radius of the ball", "m", &PushDesk::ball_m, 0.01, 0.015, "not in S3"},
    {"half of the device's width", "m", &PushDesk::body_m, 0.0175, 0.08,
     "from the Omni's upper arm to its base, as telepalp-mixed draws them; the stick crosses either"},
    {"middle of the device beside the straight way", "m", &PushDesk::beside_m, 0.0, 0.03,
     "not in S3: the stick crosses the device in the image, the handle does not"},
};

std::vector<Row> run_observer(std::uint64_t seed, std::size_t number) {
  const std::size_t condition = order_of(seed, number, 2)[0];
  device::Random self(seed_of(seed, kObserver, number));
  const Pusher person = draw(pusher_ranges(), self);
  const PushDesk desk = draw(desk_ranges(), self);
  device::Random random(seed_of(seed, kTask, number));
  Pushed at{.ball_m = {desk.pockets_m, 0.0}, .stick_m = {desk.pockets_m + 0.03, 0.0}};
  std::vector<Row> rows;
  for (int move = 0; move < kMoves; ++move) {
    const bool to_blue = move % 2 == 1;
    const Push push = push_ball(person, desk, to_blue, move, condition == 0, at, random);
    rows.push_back({number, condition, move, {to_blue ? 1.0 : 0.0, push.seconds, push.path_m, push.done ? 1.0 : 0.0}});
  }
  return rows;
}

/// The mean of `value` over an observer's compared moves to the blue pocket or away from it; nullopt: over both.
Measure measure_of(const std::vector<Row>& rows, const std::string& name, const std::string& unit, Value value,
                   double scale, std::optional<bool> to_blue) {
  Measure out{.name = name, .unit = unit, .first = {}, .second = {}};
  for (std::size_t i = 0; i < rows.size(); i += kMoves) {
    double sum = 0.0, count = 0.0;
    for (std::size_t k = i + kTrainingMoves; k < i + kMoves; ++k)
      if (!to_blue || (rows[k].values[kToBlue] != 0.0) == *to_blue) {
        sum += scale * rows[k].values[value];
        count += 1.0;
      }
    (rows[i].condition == 0 ? out.first : out.second).push_back(sum / count);
  }
  return out;
}

std::vector<Measure> measures_of(const std::vector<Row>& rows) {
  Measure green_to_blue = measure_of(rows, "time, green to blue", "s", kSeconds, 1.0, true);
  green_to_blue.paper = {{10.34, 3.57, 15}, {6.96, 1.43, 15}};
  green_to_blue.paper_says = "Welch t = 3.49, p = 0.003, power 0.96";
  Measure blue_to_green = measure_of(rows, "time, blue to green", "s", kSeconds, 1.0, false);
  blue_to_green.paper = {{8.68, 3.3, 15}, {6.94, 1.65, 15}};
  blue_to_green.paper_says = "Welch t = 1.82, p = 0.084, power 0.55";
  Measure path = measure_of(rows, "path of the stick", "mm", kPath_m, 1e3, std::nullopt);
  path.paper_says = "\"exactly the same trend as for completion times\"; no length is printed";
  return {std::move(green_to_blue), std::move(blue_to_green), std::move(path)};
}

std::vector<std::string> findings_of(const std::vector<Row>& rows) {
  int given_up = 0;
  std::array<double, 2> path_m{}, time_s{};
  for (const Row& row : rows) {
    given_up += row.values[kDone] == 0.0 ? 1 : 0;
    time_s[row.condition] += row.values[kSeconds];
    path_m[row.condition] += row.values[kPath_m];
  }
  const auto speed = [&](std::size_t condition) { return fixed_text(1e3 * path_m[condition] / time_s[condition]); };
  return {"Mean speeds: " + speed(0) + " mm/s with the device in sight, " + speed(1) +
              " mm/s with the device hidden (S3: 28.5 and 29.0). The times differ because the paths do.",
          std::to_string(given_up) + " of " + std::to_string(rows.size()) + " moves were given up after " +
              fixed_text(kLongestPush_s, 0) + " s."};
}

std::vector<Curves> curves_of(const std::vector<std::string>& conditions, const std::vector<Row>& rows) {
  Curves curves{.title = "Mean time of each move", .x_label = "move", .y_label = "time [s]", .curves = {}};
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    std::array<double, kMoves> sums{}, counts{};
    for (const Row& row : rows)
      if (row.condition == c) {
        sums[static_cast<std::size_t>(row.trial)] += row.values[kSeconds];
        counts[static_cast<std::size_t>(row.trial)] += 1.0;
      }
    curves.curves.push_back({conditions[c], {}, {}});
    for (std::size_t move = 0; move < kMoves; ++move) {
      curves.curves.back().x.push_back(static_cast<double>(move + 1));
      curves.curves.back().y.push_back(sums[move] / counts[move]);
    }
  }
  return {curves};
}

}  // namespace

std::span<const Drawn<Pusher>> pusher_ranges() noexcept { return kPushers; }
std::span<const Drawn<PushDesk>> desk_ranges() noexcept { return kDesks; }

Experiment obstruction_experiment() {
  Experiment out;
  out.name = "obstruction";
  out.title = "A ball pushed between two pockets, with the device in sight and hidden";
  out.task =
      "An observer pushes a ball with a stick between a blue and a green pocket, six times, as quickly as possible. "
      "Each observer takes part in one condition. The last four moves are compared. In sight, the device makes the "
      "observer go around it; hidden, it does not.";
  out.conditions = {"in sight", "hidden"};
  out.subjects = Subjects::Between;
  out.columns = "observer,condition,trial,to_blue,seconds,path_m,done";
  out.ranges = in_words(pusher_ranges());
  for (RangeWords& one : in_words(desk_ranges())) out.ranges.push_back(std::move(one));
  out.limits = {
      "That people avoid a device in sight is an assumption here (share of the detour, 0 to 1). The study shows how "
      "long the detour takes, not that people make it. S3's people are the evidence.",
      "A ball is harder to push along a curve: it rolls off the stick, and the stick goes after it. So the path "
      "grows by more than the detour. How much more depends on the one way of pushing that is simulated.",
      "The speed of the hand is S3's, so the times' size is no prediction; their ratio is.",
      "Both directions are alike here. In S3 they differ: 33 % less time from green to blue, 20 % (not significant) "
      "back. S3 suspects the place of the pockets and the hand's own shadow on them; neither is simulated.",
      "No observer gets used to the device. S3 saw no such effect in six moves."};
  out.run = run_observer;
  out.measures = measures_of;
  out.findings = findings_of;
  out.curves = [conditions = out.conditions](const std::vector<Row>& rows) { return curves_of(conditions, rows); };
  return out;
}

}  // namespace telepalp::study
