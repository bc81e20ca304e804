#include "server/plan/rate_plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace telepalp::plan {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kLearnsAfter = 300ms;  ///< images of the old settings are still made and counted until then
// Bytes of an image at rung 0, until the first was made: about those of the synthetic patient.
constexpr double kFirstWindow_B = 25'000.0;
constexpr double kFirstWhole_B = 60'000.0;
constexpr double kFirstPicture_B = 40'000.0;
constexpr Nanoseconds kTooThinAfter = 1s;  ///< the first measurement of a line that has become thinner may be too low
constexpr double kVideoOfRest = 0.9;       ///< of what the other images leave: single video frames exceed the mean
constexpr double kVideoStep = 0.1;         ///< video keeps its rate if the new one differs by a smaller share

Taken taken_by(const Line& line, double images_per_s) {
  return {.images_per_s = images_per_s,
          .depth = line.takes_window || line.takes_whole,
          .pictures = line.takes_pictures,
          .video = line.takes_video};
}

/// Raises the rate of video by most of `rest_B_per_s`, which the rung leaves of the budget.
void give_rest_to_video(ImageSettings& settings, double rest_B_per_s, int before_kbit_per_s) {
  const int wanted = std::min(
      kFullVideo_kbit_per_s, settings.video_kbit_per_s + static_cast<int>(kVideoOfRest * rest_B_per_s / kBytesPerKbit));
  const bool is_near = std::abs(wanted - before_kbit_per_s) <= kVideoStep * wanted;
  settings.video_kbit_per_s = is_near && before_kbit_per_s >= settings.video_kbit_per_s ? before_kbit_per_s : wanted;
}

}  // namespace

RatePlanner::RatePlanner()
    : touch_(touch_rungs(), {.depth_B = kFirstWindow_B, .picture_B = kFirstPicture_B}),
      view_(view_rungs(), {.depth_B = kFirstWhole_B, .picture_B = kFirstPicture_B}) {}

const RatePlan& RatePlanner::step(const PlanInput& input, SessionTime now) {
  learn(input, now);
  keep_budgets(input, now);
  plan_.grades.clear();
  plan_.sacrifice.images_per_s = input.images_per_s;
  plan_touch(input, now);
  plan_view(input, now);
  return plan_;
}

void RatePlanner::learn(const PlanInput& input, SessionTime now) {
  const auto mean_B = [](const Made::Count& made) {
    return made.images == 0 ? 0.0 : static_cast<double>(made.bytes) / static_cast<double>(made.images);
  };
  // At rung 0, these subscribers get the images of Full.
  const auto made_at = [&](Grade grade, std::size_t rung) -> const Made& {
    return input.made[index_of(rung == 0 ? Grade::Full : grade)];
  };
  const auto [touch_rung, view_rung] = std::pair{plan_.sacrifice.touch_rung, plan_.sacrifice.view_rung};
  const Made& touch = made_at(Grade::Touch, touch_rung);
  const Made& view = made_at(Grade::View, view_rung);
  if (now - touch_changed_ > kLearnsAfter) touch_.measured(touch_rung, mean_B(touch.window), mean_B(touch.pictures));
  if (now - view_changed_ > kLearnsAfter) view_.measured(view_rung, mean_B(view.whole), mean_B(view.pictures));
}

void RatePlanner::keep_budgets(const PlanInput& input, SessionTime now) {
  std::map<std::uint64_t, LineBudget> kept;
  for (const Line& line : input.lines) {
    const bool is_hand = line.kind == Line::Kind::Hand;
    if (!is_hand && line.kind != Line::Kind::Viewer) continue;
    LineBudget& budget = kept[line.subscriber] = budgets_[line.subscriber];
    budget.step(line.report, (is_hand ? touch_ : view_).rate_B_per_s(0, taken_by(line, input.images_per_s)), now);
  }
  budgets_ = std::move(kept);
}

/// The least budget of the lines of `kind`; nullopt: each of them has room for everything.
std::optional<double> RatePlanner::least_budget_B_per_s(const PlanInput& input, Line::Kind kind) const {
  std::optional<double> least;
  for (const Line& line : input.lines) {
    if (line.kind != kind) continue;
    const std::optional<double> budget = budgets_.at(line.subscriber).B_per_s();
    if (budget) least = std::min(least.value_or(*budget), *budget);
  }
  return least;
}

/// What the rung leaves of the budget goes to the rate of depth, then to video. Only video gets the part that is merely
/// tried, because a lost video frame hurts less than lost depth.
ImageSettings RatePlanner::touch_settings(std::size_t rung, const Line& hand, const Taken& taken,
                                          int video_before_kbit_per_s) const {
  ImageSettings settings = touch_rungs()[rung].settings;
  const LineBudget& budget = budgets_.at(hand.subscriber);
  const double needed_B_per_s = touch_.rate_B_per_s(rung, taken);
  const double rest_B_per_s = std::max(0.0, budget.B_per_s().value_or(0.0) - needed_B_per_s);
  const double raised = touch_.depth_share(rung, taken, rest_B_per_s);
  const double depth_B_per_s = touch_.rate_B_per_s(rung, {.images_per_s = taken.images_per_s, .depth = taken.depth});
  const double more_depth_B_per_s = (raised / settings.depth_share - 1.0) * depth_B_per_s;
  settings.depth_share = raised;
  const double tried_B_per_s = budget.tried_B_per_s() - needed_B_per_s - more_depth_B_per_s;
  give_rest_to_video(settings, std::max(0.0, tried_B_per_s), video_before_kbit_per_s);
  return settings;
}

void RatePlanner::plan_touch(const PlanInput& input, SessionTime now) {
  Sacrifice& sacrifice = plan_.sacrifice;
  sacrifice.hand_B_per_s = least_budget_B_per_s(input, Line::Kind::Hand);
  const auto hand = std::ranges::find(input.lines, Line::Kind::Hand, &Line::kind);
  std::size_t rung = 0;
  ImageSettings settings;
  if (sacrifice.hand_B_per_s) {
    const Taken taken = taken_by(*hand, input.images_per_s);
    rung = touch_.fitting(*sacrifice.hand_B_per_s, taken, sacrifice.touch_rung);
    const int video_before = plan_.settings[index_of(Grade::Touch)].video_kbit_per_s;
    if (rung > 0) settings = touch_settings(rung, *hand, taken, video_before);
  }
  settings.level = input.whole_level;
  plan_.settings[index_of(Grade::Touch)] = settings;
  if (std::exchange(sacrifice.touch_rung, rung) != rung) touch_changed_ = now;
  if (!is_too_thin_to_touch(touch_rungs()[rung])) enough_at_ = now;
  sacrifice.too_thin_to_touch = now - enough_at_ > kTooThinAfter;
  if (plan_.grade_of_stations() == Grade::Full) return;
  for (const Line& line : input.lines)
    if (line.kind == Line::Kind::Hand || line.kind == Line::Kind::Station) plan_.grades[line.subscriber] = Grade::Touch;
}

void RatePlanner::plan_view(const PlanInput& input, SessionTime now) {
  Sacrifice& sacrifice = plan_.sacrifice;
  const bool hand_is_thin = sacrifice.touch_rung > 0;
  sacrifice.viewer_B_per_s = least_budget_B_per_s(input, Line::Kind::Viewer);
  std::size_t rung = hand_is_thin ? color_given_up() : 0;
  for (const Line& line : input.lines) {
    if (line.kind != Line::Kind::Viewer) continue;
    if (const std::optional<double> budget = budgets_.at(line.subscriber).B_per_s())
      rung = std::max(rung, view_.fitting(*budget, taken_by(line, input.images_per_s), sacrifice.view_rung));
  }
  for (const Line& line : input.lines)
    if (rung > 0 && line.kind == Line::Kind::Viewer && (hand_is_thin || budgets_.at(line.subscriber).B_per_s()))
      plan_.grades[line.subscriber] = Grade::View;
  if (std::exchange(sacrifice.view_rung, rung) != rung) view_changed_ = now;
  plan_.settings[index_of(Grade::View)] = view_rungs()[rung].settings;
}

}  // namespace telepalp::plan
