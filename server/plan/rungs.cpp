#include "server/plan/rungs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace telepalp::plan {
namespace {

constexpr double kMarginUp = 1.05;         ///< images of the same settings differ by a few percent
constexpr double kShareStep = 1.0 / 30.0;  ///< one image per second of a 30 Hz camera
// Where a measured size and its guess differ by more than this factor, the scene has changed, and with it the sizes at
// all rungs. Where they differ by less, only the guess for this rung was wrong.
constexpr double kGuessIsWithin = 2.0;

constexpr double kThird = 1.0 / 3.0;
constexpr double kSixth = 1.0 / 6.0;

constexpr Rung kEverything{.settings = {.video_kbit_per_s = kFullVideo_kbit_per_s}};

/// Depth around the window.
struct Around {
  double factor = 1.0;
  int every = 1;
  double depth_bytes = 1.0;
};
struct Color {
  double share = 1.0;
  int jpeg = 100;
  int kbit_per_s = kFullVideo_kbit_per_s;
  double picture_bytes = 1.0;
};

constexpr Rung touch(const Color& color, const Around& around, double depth_share) {
  return {.settings = {.depth_share = depth_share,
                       .outside_factor = around.factor,
                       .outside_every = around.every,
                       .color_share = color.share,
                       .jpeg_quality = color.jpeg,
                       .video_kbit_per_s = color.kbit_per_s},
          .depth_bytes = around.depth_bytes,
          .picture_bytes = color.picture_bytes};
}

constexpr Color kTwelveHertz{.share = 0.4, .jpeg = 25, .kbit_per_s = 200, .picture_bytes = 0.35};
constexpr Color kFiveHertz{.share = kSixth, .jpeg = 25, .kbit_per_s = 100, .picture_bytes = 0.35};
constexpr Color kThreeHertz{.share = 0.1, .jpeg = 25, .kbit_per_s = 60, .picture_bytes = 0.35};
constexpr Around kLeast{.factor = 4, .every = 6, .depth_bytes = 0.62};
constexpr std::array kTouch{
    kEverything,
    touch({.share = 0.5, .jpeg = 60, .kbit_per_s = 400, .picture_bytes = 0.6}, {}, 1.0),
    touch({.share = 0.4, .jpeg = 40, .kbit_per_s = 250, .picture_bytes = 0.45}, {}, 1.0),
    touch(kTwelveHertz, {.factor = 2, .depth_bytes = 0.85}, 1.0),
    touch(kTwelveHertz, {.factor = 4, .depth_bytes = 0.75}, 1.0),
    touch(kTwelveHertz, {.factor = 4, .every = 2, .depth_bytes = 0.68}, 1.0),
    touch(kTwelveHertz, {.factor = 4, .every = 3, .depth_bytes = 0.65}, 1.0),
    touch(kTwelveHertz, kLeast, 1.0),
    touch(kFiveHertz, kLeast, 1.0),
    touch(kFiveHertz, kLeast, 0.9),
    touch(kFiveHertz, kLeast, 0.8),
    touch(kFiveHertz, kLeast, 0.7),
    touch(kFiveHertz, kLeast, 0.6),
    touch(kThreeHertz, kLeast, 0.5),
    touch(kThreeHertz, kLeast, kThird),
};
static_assert(std::ranges::count_if(kTouch, is_too_thin_to_touch) == 1 && is_too_thin_to_touch(kTouch.back()));

/// Whole depth images.
struct Whole {
  double factor = 0.0;
  double share = 1.0;
  double depth_bytes = 0.7;
};

/// Level 1: lossless depth is intra instead of fast, which is as exact, but smaller.
constexpr Rung view(const Color& color, const Whole& whole) {
  return {.settings = {.level = 1,
                       .whole_factor = whole.factor,
                       .depth_share = whole.share,
                       .color_share = color.share,
                       .jpeg_quality = color.jpeg,
                       .video_kbit_per_s = color.kbit_per_s},
          .depth_bytes = whole.depth_bytes,
          .picture_bytes = color.picture_bytes};
}

constexpr Color kTenHertz{.share = kThird, .jpeg = 25, .kbit_per_s = 150, .picture_bytes = 0.35};
constexpr Color kTwoHertz{.share = 1.0 / 15.0, .jpeg = 25, .kbit_per_s = 40, .picture_bytes = 0.35};
constexpr std::array kView{
    kEverything,
    view({.share = 1.0, .jpeg = 60, .kbit_per_s = 480, .picture_bytes = 0.6}, {}),
    view({.share = 0.5, .jpeg = 40, .kbit_per_s = 250, .picture_bytes = 0.45}, {}),
    view(kTenHertz, {}),
    view(kTenHertz, {.factor = 1, .depth_bytes = 0.4}),
    view(kTenHertz, {.factor = 2, .depth_bytes = 0.33}),
    view(kFiveHertz, {.factor = 4, .share = 0.5, .depth_bytes = 0.27}),
    view(kThreeHertz, {.factor = 4, .share = kThird, .depth_bytes = 0.27}),
    view(kThreeHertz, {.factor = 4, .share = kSixth, .depth_bytes = 0.27}),
    view(kTwoHertz, {.factor = 4, .share = 1.0 / 15.0, .depth_bytes = 0.27}),
};

constexpr bool gives_up_depth(const Rung& rung) noexcept {
  return rung.settings.whole_factor > 0.0 || rung.settings.depth_share < 1.0;
}
constexpr auto kColorGivenUp = std::ranges::find_if(kView, gives_up_depth) - kView.begin() - 1;
static_assert(kColorGivenUp > 0 && kView[kColorGivenUp].settings.color_share < 1.0);

}  // namespace

std::span<const Rung> touch_rungs() noexcept { return kTouch; }
std::span<const Rung> view_rungs() noexcept { return kView; }
std::size_t color_given_up() noexcept { return kColorGivenUp; }

RungBytes::RungBytes(std::span<const Rung> rungs, const FirstGuess& at_full) : rungs_(rungs) {
  for (const Rung& rung : rungs) {
    depth_B_.push_back(at_full.depth_B * rung.depth_bytes);
    picture_B_.push_back(at_full.picture_B * rung.picture_bytes);
  }
}

void RungBytes::measured(std::size_t rung, double depth_B, double picture_B) noexcept {
  const bool is_new = std::exchange(last_, rung) != rung;
  const auto learn = [&](std::vector<double>& bytes, double mean_B) {
    if (mean_B <= 0.0) return;
    const double ratio = mean_B / bytes[rung];
    // Right after a change of the rung, the scene is still the same, so only the guess for the new rung was wrong.
    if (is_new && ratio > 1.0 / kGuessIsWithin && ratio < kGuessIsWithin)
      bytes[rung] = mean_B;
    else
      for (double& one : bytes) one *= ratio;
  };
  learn(depth_B_, depth_B);
  learn(picture_B_, picture_B);
}

double RungBytes::rate_B_per_s(std::size_t rung, const Taken& taken) const noexcept {
  const ImageSettings& sent = rungs_[rung].settings;
  double rate = taken.depth ? taken.images_per_s * sent.depth_share * depth_B_[rung] : 0.0;
  if (taken.pictures) rate += taken.images_per_s * sent.color_share * picture_B_[rung];
  if (taken.video) rate += kBytesPerKbit * sent.video_kbit_per_s;
  return rate;
}

double RungBytes::depth_share(std::size_t rung, const Taken& taken, double rest_B_per_s) const noexcept {
  const double share = rungs_[rung].settings.depth_share;
  if (rung == 0 || share >= 1.0 || !taken.depth || taken.images_per_s <= 0.0) return share;
  const double more = share + rest_B_per_s / (taken.images_per_s * depth_B_[rung]);
  const double stepped = std::floor(more / kShareStep + 1e-6) * kShareStep;
  return std::clamp(stepped, share, rungs_[rung - 1].settings.depth_share);
}

std::size_t RungBytes::fitting(double budget_B_per_s, const Taken& taken, std::size_t present) const noexcept {
  for (std::size_t rung = 0; rung + 1 < rungs_.size(); ++rung) {
    const double margin = rung < present ? kMarginUp : 1.0;
    if (margin * rate_B_per_s(rung, taken) <= budget_B_per_s) return rung;
  }
  return rungs_.size() - 1;
}

}  // namespace telepalp::plan
