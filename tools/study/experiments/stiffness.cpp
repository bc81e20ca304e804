#include "tools/study/experiments/stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proto/words/numbers/fixed_text.h"
#include "tools/study/jnd/quest.h"

namespace telepalp::study {
namespace {

constexpr int kMostTrials = 400;    // of one staircase, for an observer at chance
constexpr double kNearMost = 0.99;  // a difference from this share of kMostDifference on counts as the largest
constexpr std::size_t kSights = 3;  // conditions

enum AnswerValue : std::size_t { kAnswerPlace, kDifference, kRight };  // of a row, in the order of its columns

constexpr Drawn<StiffnessObserver> kStiffnessRanges[] = {
    {"force of a push", "N", &StiffnessObserver::push_N, 1.0, 3.0, "the Omni gives at most 3.3 N (its data sheet)"},
    {"spread of the push", "of the force", &StiffnessObserver::push_spread, 0.1, 0.25, "assumed: no source was found"},
    {"noise of the felt force", "of the force", &StiffnessObserver::force_noise, 0.07, 0.15,
     "Pang 1991: 7 % at 2.5 to 10 N, more below 1 N"},
    {"noise of the felt stiffness", "of the stiffness", &StiffnessObserver::touch_noise, 0.15, 0.25,
     "Jones and Hunter 1990: 23 %; Tan 1995: 22 % for compliance"},
    {"noise of a seen displacement", "of the displacement", &StiffnessObserver::sight_noise, 0.03, 0.06,
     "usual differences in length that are seen are 3 to 5 %"},
    {"noise of a seen displacement, at least", "m", &StiffnessObserver::sight_floor_m, 0.00015, 0.0004,
     "half a pixel to one pixel of S3's headset (Z800: 800 pixels over 32 degrees) at 0.4 to 0.6 m"},
    {"share of sight in the judgement", "", &StiffnessObserver::sight_weight, 0.7, 1.0,
     "Srinivasan, Beauregard and Brock 1996: sight dominates over touch; the range is assumed"},
    {"share of the seen hand in the seen displacement", "", &StiffnessObserver::hand_weight, 0.0, 0.2,
     "assumed: no source was found. It alone makes the conditions differ"},
    {"practice: fall of all noise over the conditions", "", &StiffnessObserver::practice, 0.0, 0.2,
     "assumed: no source was found"},
    {"lapses", "of the answers", &StiffnessObserver::lapses, 0.0, 0.04, "Wichmann and Hill 2001: up to 5 %"},
};

/// Natural logarithm of the stiffness that the observer perceives.
double perceived(const StiffnessObserver& person, Sight sight, double prism_N_per_m, double noise_scale,
                 device::Random& random) noexcept {
  const auto noise = [&](double deviation) { return noise_scale * deviation * random.normal(); };
  const double force_N = person.push_N * std::exp(person.push_spread * random.normal());
  const double tool_m = force_N / prism_N_per_m;
  const double hand_m = tool_m + force_N / kCoupling_N_per_m;
  const double shown_hand_m = sight == Sight::Naive ? hand_m : tool_m;
  const double shown_m = std::lerp(tool_m, shown_hand_m, person.hand_weight);
  const double seen_m = shown_m * std::exp(noise(person.sight_noise)) + noise(person.sight_floor_m);
  const double felt_N = force_N * std::exp(noise(person.force_noise));
  const double by_sight = std::log(felt_N / std::max(seen_m, 0.05 * shown_m));
  const double by_touch = std::log(force_N / hand_m) + noise(person.touch_noise);
  return std::lerp(by_touch, by_sight, sight == Sight::None ? 0.0 : person.sight_weight);
}

/// One run by either rule. Its threshold follows from the answers alone, so it is computed from the rows of the files.
class ThresholdRun {
 public:
  explicit ThresholdRun(ThresholdRule rule) : rule_(rule), stairs_({.most = kMostDifference}) {}
  [[nodiscard]] bool ended() const noexcept {
    return rule_ == ThresholdRule::Quest ? trials_ >= kQuestTrials : stairs_.ended() || trials_ >= kMostTrials;
  }
  [[nodiscard]] double difference() const noexcept {
    return rule_ == ThresholdRule::Quest ? std::min(quest_.difference(), kMostDifference) : stairs_.difference();
  }
  void answer(bool right) noexcept {
    ++trials_;
    rule_ == ThresholdRule::Quest ? quest_.answer(right) : stairs_.answer(right);
  }
  /// kMostDifference if the run did not find one.
  [[nodiscard]] double threshold() const noexcept {
    if (rule_ == ThresholdRule::Quest) return difference();
    return stairs_.threshold().value_or(kMostDifference);
  }

 private:
  ThresholdRule rule_;
  Staircase stairs_;
  Quest quest_{0.3, 1.0, kQuestTarget};
  int trials_ = 0;
};

std::vector<Row> run_observer(ThresholdRule rule, std::uint64_t seed, std::size_t number) {
  device::Random self(seed_of(seed, kObserver, number));
  const StiffnessObserver person = draw(stiffness_ranges(), self);
  const std::vector<std::size_t> order = order_of(seed, number, kSights);
  std::vector<Row> rows;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t condition = order[place];
    device::Random random(seed_of(seed, kTask * 1000 + condition, number));
    const double noise_scale = 1.0 - person.practice * static_cast<double>(place) / (kSights - 1.0);
    ThresholdRun run(rule);
    for (int trial = 0; !run.ended(); ++trial) {
      const double difference = run.difference();
      const bool right = answers_right(person, static_cast<Sight>(condition), difference, noise_scale, random);
      run.answer(right);
      rows.push_back({number, condition, trial, {static_cast<double>(place), difference, right ? 1.0 : 0.0}});
    }
  }
  return rows;
}

/// The threshold of each observer in each condition: [condition][observer].
std::vector<std::vector<double>> thresholds_of(ThresholdRule rule, const std::vector<Row>& rows) {
  std::vector<std::vector<ThresholdRun>> runs(kSights);
  for (const Row& row : rows) {
    std::vector<ThresholdRun>& of_condition = runs[row.condition];
    while (of_condition.size() <= row.observer) of_condition.emplace_back(rule);
    of_condition[row.observer].answer(row.values[kRight] != 0.0);
  }
  std::vector<std::vector<double>> thresholds(kSights);
  for (std::size_t i = 0; i < kSights; ++i)
    for (const ThresholdRun& run : runs[i]) thresholds[i].push_back(run.threshold());
  return thresholds;
}

std::vector<Measure> answer_measures(ThresholdRule rule, const std::vector<Row>& rows) {
  const auto thresholds = thresholds_of(rule, rows);
  Measure fraction{.name = "Weber fraction", .unit = "", .first = thresholds[0], .second = thresholds[1]};
  Measure jnd{.name = "just noticeable difference", .unit = "N/m", .first = thresholds[0], .second = thresholds[1]};
  for (std::vector<double>* values : {&jnd.first, &jnd.second})
    for (double& value : *values) value *= kPrism_N_per_m;
  jnd.paper = {{561.0, 114.0, 10}, {418.0, 103.0, 10}};
  jnd.paper_says = "no test of the JND is printed";
  fraction.paper = {{0.42, 0.088, 10}, {0.33, 0.098, 10}};
  fraction.paper_says =
      "paired t = 4.7, p = 0.001, power 0.98. JND / 1400 N/m is 0.40 and 0.30: S3 does not say to which stiffness "
      "its fractions refer";
  return {std::move(jnd), std::move(fraction)};
}

std::vector<std::string> answer_findings(const std::vector<Row>& rows) {
  std::array<std::vector<bool>, kSights> at_the_end;  // observers who were shown the largest difference
  for (const Row& row : rows) {
    std::vector<bool>& of_condition = at_the_end[row.condition];
    of_condition.resize(std::max(of_condition.size(), row.observer + 1), false);
    if (row.values[kDifference] >= kNearMost * kMostDifference) of_condition[row.observer] = true;
  }
  const auto count = [&](std::size_t condition) {
    return std::to_string(std::count(at_the_end[condition].begin(), at_the_end[condition].end(), true)) + " of " +
           std::to_string(at_the_end[condition].size());
  };
  const auto felt = [](double difference) {
    const double prism = kPrism_N_per_m * (1.0 + difference);
    return prism * kCoupling_N_per_m / (prism + kCoupling_N_per_m);
  };
  const auto share = [&](double difference) { return fixed_text(100.0 * (felt(difference) / felt(0.0) - 1.0)) + " %"; };
  return {"Behind the coupling of 200 N/m the hand feels little of it: S3's differences of 418 and 561 N/m arrive as " +
              share(418.0 / kPrism_N_per_m) + " and " + share(561.0 / kPrism_N_per_m) + ", and a prism of " +
              fixed_text(kPrism_N_per_m * (1.0 + kMostDifference), 0) + " N/m as " + share(kMostDifference) + ".",
          "A run that reached the largest difference of " + fixed_text(kPrism_N_per_m * kMostDifference, 0) +
              " N/m did not find a threshold: without sight " + count(2) + " observers, naive " + count(0) +
              ", corrected " + count(1) + ". So what the seen conditions tell comes from sight."};
}

std::vector<Curves> answer_curves(const std::vector<std::string>& conditions, const std::vector<Row>& rows) {
  Curves curves{
      .title = "The trials of observer 1", .x_label = "trial", .y_label = "difference shown [%]", .curves = {}};
  for (const std::string& condition : conditions) curves.curves.push_back({condition, {}, {}});
  for (const Row& row : rows) {
    if (row.observer != 0) continue;
    curves.curves[row.condition].x.push_back(row.trial + 1);
    curves.curves[row.condition].y.push_back(100.0 * row.values[kDifference]);
  }
  return {curves};
}

std::string task_words(ThresholdRule rule) {
  const std::string start =
      "An observer pushes two prisms sideways through a coupling of 200 N/m and tells which one is stiffer. One has "
      "1400 N/m, the other one is stiffer. ";
  if (rule == ThresholdRule::Quest)
    return start +
           "Rule: QUEST, 100 trials, each at the mean of the threshold's distribution; the target is 75 % "
           "right answers.";
  return start +
         "Rule: after a wrong answer the difference grows by 28 %, after three right answers in a row it "
         "falls by 17 %; the target is 83.15 % right answers (García-Pérez 1998). 24 reversals; the "
         "threshold is the geometric mean of the last 20. S3 refers to another paper for its rule.";
}

}  // namespace

std::span<const Drawn<StiffnessObserver>> stiffness_ranges() noexcept { return kStiffnessRanges; }

bool answers_right(const StiffnessObserver& person, Sight sight, double difference, double noise_scale,
                   device::Random& random) noexcept {
  const double reference = perceived(person, sight, kPrism_N_per_m, noise_scale, random);
  const double stiffer = perceived(person, sight, kPrism_N_per_m * (1.0 + difference), noise_scale, random);
  const bool right = stiffer > reference;
  if (random.uniform() < person.lapses) return random.uniform() < 0.5;
  return right;
}

Experiment stiffness_experiment(ThresholdRule rule) {
  Experiment out;
  out.name = "stiffness-jnd";
  out.title = "Stiffness told with and without the hand at the tool";
  out.task = task_words(rule);
  out.conditions = {"naive", "corrected", "no sight"};
  out.subjects = Subjects::Within;
  out.columns = "observer,condition,trial,place,difference,right";
  out.variant = rule == ThresholdRule::Quest ? "quest" : "staircase";
  out.ranges = in_words(stiffness_ranges());
  out.limits = {
      "That a seen hand which sinks further than the tool disturbs the judgement of stiffness is an assumption here "
      "(share of the seen hand, 0 to 0.2). The difference between the conditions follows from it and is no evidence "
      "for it. S3's people are the evidence.",
      "The prism is a spring of 1400 N/m. S3's prism is a body of finite elements whose bending is seen as a whole.",
      "Nothing is shown of how people move: an observer pushes once, with one force.",
      "No observer notices that the hand is drawn elsewhere than it is felt. S3 reports that nobody did."};
  out.run = [rule](std::uint64_t seed, std::size_t observer) { return run_observer(rule, seed, observer); };
  out.measures = [rule](const std::vector<Row>& rows) { return answer_measures(rule, rows); };
  out.findings = answer_findings;
  out.curves = [conditions = out.conditions](const std::vector<Row>& rows) { return answer_curves(conditions, rows); };
  return out;
}

}  // namespace telepalp::study
