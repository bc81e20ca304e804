#include "server/plan/rate_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace telepalp::plan {
namespace {

using namespace std::chrono_literals;

/// After a change, images of the old settings are still being made and sent.
constexpr Nanoseconds kLearnsAfter = 300ms;
// Bytes of an image at rung 0, until the first was made: about those of the synthetic patient.
constexpr double kFirstWindow_B = 25'000.0;
constexpr double kFirstWhole_B = 60'000.0;
constexpr double kFirstPicture_B = 40'000.0;
constexpr Nanoseconds kSaidFor = 3s;
constexpr Nanoseconds kTooThinAfter = 1s;  ///< a line that has just become thinner is measured first
constexpr double kFewerBytesUsed = 0.9;    ///< share of what is left over that goes to video
constexpr double kVideoStep = 0.1;         ///< smaller changes of video's rate are left out

Taken taken_by(const Line& line, double images_per_s) {
  return {.images_per_s = images_per_s,
          .depth = line.takes_window || line.takes_whole,
          .pictures = line.takes_pictures,
          .video = line.takes_video};
}

std::string in_Mbit_per_s(double B_per_s) {
  const auto tenths = static_cast<long>(std::lround(8e-5 * B_per_s));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " Mbit/s";
}

/// Video gets what the other images leave of `budget_B_per_s`.
void give_rest_to_video(ImageSettings& settings, double rest_B_per_s, int before_kbit_per_s) {
  const int wanted = std::min(kFullVideo_kbit_per_s,
                              settings.video_kbit_per_s + static_cast<int>(8e-3 * kFewerBytesUsed * rest_B_per_s));
  const bool is_near = std::abs(wanted - before_kbit_per_s) <= kVideoStep * wanted;
  settings.video_kbit_per_s = is_near && before_kbit_per_s >= settings.video_kbit_per_s ? before_kbit_per_s : wanted;
}

}  // namespace

RatePlanner::RatePlanner()
    : touch_(touch_rungs(), {.depth_B = kFirstWindow_B, .picture_B = kFirstPicture_B}),
      view_(view_rungs(), {.depth_B = kFirstWhole_B, .picture_B = kFirstPicture_B}) {}

const RatePlan& RatePlanner::step(const PlanInput& input, SessionTime now) {
  now_ = now;
  images_per_s_ = input.images_per_s;
  learn(input);
  keep_budgets(input, now);
  plan_.grades.clear();
  plan_.too_thin_to_touch = false;
  plan_touch(input, now);
  plan_view(input, now);
  tell();
  return plan_;
}

void RatePlanner::learn(const PlanInput& input) {
  const auto mean_B = [](const Made::Count& made) {
    return made.images == 0 ? 0.0 : static_cast<double>(made.bytes) / static_cast<double>(made.images);
  };
  // At rung 0 these subscribers get the images of Full.
  const auto made_at = [&](Grade grade, std::size_t rung) -> const Made& {
    return input.made[index_of(rung == 0 ? Grade::Full : grade)];
  };
  const Made& touch = made_at(Grade::Touch, touch_rung_);
  const Made& view = made_at(Grade::View, view_rung_);
  if (now_ - touch_changed_ > kLearnsAfter) touch_.measured(touch_rung_, mean_B(touch.window), mean_B(touch.pictures));
  if (now_ - view_changed_ > kLearnsAfter) view_.measured(view_rung_, mean_B(view.whole), mean_B(view.pictures));
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

/// What is left of the budget goes to the rate of depth, then to video. Only video gets what is merely tried.
ImageSettings RatePlanner::touch_settings(std::size_t rung, const Line& hand, const Taken& taken,
                                          int video_before_kbit_per_s) {
  ImageSettings settings = touch_rungs()[rung].settings;
  const LineBudget& budget = budgets_[hand.subscriber];
  const double needed_B_per_s = touch_.rate_B_per_s(rung, taken);
  const double rest_B_per_s = std::max(0.0, budget.B_per_s().value_or(0.0) - needed_B_per_s);
  const double rung_share = settings.depth_share;
  settings.depth_share = touch_.depth_share(rung, taken, rest_B_per_s);
  const double used = settings.depth_share / rung_share;
  const double depth_B_per_s = touch_.rate_B_per_s(rung, {.images_per_s = taken.images_per_s, .depth = taken.depth});
  const double tried_B_per_s = budget.tried_B_per_s() - needed_B_per_s - (used - 1.0) * depth_B_per_s;
  give_rest_to_video(settings, std::max(0.0, tried_B_per_s), video_before_kbit_per_s);
  return settings;
}

void RatePlanner::plan_touch(const PlanInput& input, SessionTime now) {
  const auto hand = std::ranges::find(input.lines, Line::Kind::Hand, &Line::kind);
  const std::optional<double> budget = hand == input.lines.end() ? std::nullopt : budgets_[hand->subscriber].B_per_s();
  ImageSettings& settings = plan_.settings[index_of(Grade::Touch)];
  const int video_before = settings.video_kbit_per_s;
  std::size_t rung = 0;
  settings = {};
  hand_B_per_s_ = budget.value_or(0.0);
  if (budget) {
    const Taken taken = taken_by(*hand, input.images_per_s);
    rung = touch_.fitting(*budget, taken, touch_rung_);
    if (rung > 0) settings = touch_settings(rung, *hand, taken, video_before);
  }
  settings.level = input.whole_level;
  touch_changed_ = rung == touch_rung_ ? touch_changed_ : now;
  touch_rung_ = rung;
  if (rung != kTooThinToTouch) enough_at_ = now;
  plan_.too_thin_to_touch = now - enough_at_ > kTooThinAfter;
  if (settings == ImageSettings{}) return;
  for (const Line& line : input.lines)
    if (line.kind == Line::Kind::Hand || line.kind == Line::Kind::Station) plan_.grades[line.subscriber] = Grade::Touch;
}

void RatePlanner::plan_view(const PlanInput& input, SessionTime now) {
  const bool hand_is_thin = touch_rung_ > 0;
  std::size_t rung = hand_is_thin ? kColorGivenUp : 0;
  viewer_B_per_s_ = 0.0;
  for (const Line& line : input.lines) {
    if (line.kind != Line::Kind::Viewer) continue;
    const std::optional<double> budget = budgets_[line.subscriber].B_per_s();
    if (!budget) continue;
    rung = std::max(rung, view_.fitting(*budget, taken_by(line, input.images_per_s), view_rung_));
    viewer_B_per_s_ = viewer_B_per_s_ > 0.0 ? std::min(viewer_B_per_s_, *budget) : *budget;
  }
  for (const Line& line : input.lines)
    if (rung > 0 && line.kind == Line::Kind::Viewer && (hand_is_thin || budgets_[line.subscriber].B_per_s()))
      plan_.grades[line.subscriber] = Grade::View;
  if (rung != view_rung_) view_changed_ = now;
  view_rung_ = rung;
  plan_.settings[index_of(Grade::View)] = view_rungs()[rung].settings;
}

/// A sentence stays for a while, so that people can read it, and names the rate of the moment when it was made.
void RatePlanner::tell() {
  const std::pair now_given_up{touch_rung_, viewer_B_per_s_ > 0.0 ? view_rung_ : 0};
  const bool fresh = now_ - said_at_ < kSaidFor && !plan_.said.empty() && now_given_up != std::pair{0UL, 0UL};
  if (now_given_up == said_ || fresh) return;
  said_ = now_given_up;
  said_at_ = now_;
  plan_.said.clear();
  if (plan_.too_thin_to_touch)
    plan_.said = "too thin to touch: the line to the station carries about " + in_Mbit_per_s(hand_B_per_s_) +
                 " of images, not enough for exact depth 15 times a second";
  else if (touch_rung_ > 0)
    plan_.said = "the line to the station carries about " + in_Mbit_per_s(hand_B_per_s_) +
                 " of images; given up: " + given_up(touch_rungs()[touch_rung_].settings, images_per_s_, true);
  if (said_.second == 0) return;
  plan_.said += (plan_.said.empty() ? "" : "; ") + std::string("the line to a viewer carries about ") +
                in_Mbit_per_s(viewer_B_per_s_) +
                " of images; given up there: " + given_up(view_rungs()[view_rung_].settings, images_per_s_, false);
}

}  // namespace telepalp::plan
