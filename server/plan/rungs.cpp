#include "server/plan/rungs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::plan {
namespace {

constexpr double kMarginUp = 1.05;
constexpr double kShareStep = 1.0 / 30.0;  ///< one image a second

constexpr double kThird = 1.0 / 3.0;
constexpr double kSixth = 1.0 / 6.0;

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
constexpr Around kLeast{.factor = 4, .every = 6, .depth_bytes = 0.62};
constexpr std::array kTouch{
    touch({}, {}, 1.0),
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
    touch({.share = 0.1, .jpeg = 25, .kbit_per_s = 60, .picture_bytes = 0.35}, kLeast, 0.5),
    touch({.share = 0.1, .jpeg = 25, .kbit_per_s = 60, .picture_bytes = 0.35}, kLeast, kThird),
};
static_assert(kTouch.size() == kTooThinToTouch + 1);

constexpr Rung view(double whole_factor, double depth_share, double color_share, int jpeg, int kbit_per_s,
                    double depth_bytes, double picture_bytes) {
  return {.settings = {.level = depth_bytes < 1.0 ? std::size_t{1} : std::size_t{0},
                       .whole_factor = whole_factor,
                       .depth_share = depth_share,
                       .color_share = color_share,
                       .jpeg_quality = jpeg,
                       .video_kbit_per_s = kbit_per_s},
          .depth_bytes = depth_bytes,
          .picture_bytes = picture_bytes};
}

constexpr std::array kView{
    view(0, 1.0, 1.0, 100, kFullVideo_kbit_per_s, 1.0, 1.0),
    view(0, 1.0, 1.0, 60, 480, 0.7, 0.6),
    view(0, 1.0, 0.5, 40, 250, 0.7, 0.45),
    view(0, 1.0, kThird, 25, 150, 0.7, 0.35),
    view(1, 1.0, kThird, 25, 150, 0.4, 0.35),
    view(2, 1.0, kThird, 25, 150, 0.33, 0.35),
    view(4, 0.5, kSixth, 25, 100, 0.27, 0.35),
    view(4, kThird, 0.1, 25, 60, 0.27, 0.35),
    view(4, kSixth, 0.1, 25, 60, 0.27, 0.35),
    view(4, 1.0 / 15.0, 1.0 / 15.0, 25, 40, 0.27, 0.35),
};
static_assert(kView[kColorGivenUp].settings.whole_factor == 0.0);

}  // namespace

std::span<const Rung> touch_rungs() noexcept { return kTouch; }
std::span<const Rung> view_rungs() noexcept { return kView; }

std::string given_up(const ImageSettings& sent, double images_per_s, bool has_window) {
  std::string list;
  const auto add = [&](const std::string& what) { list += (list.empty() ? "" : ", ") + what; };
  const auto times = [&](double share) {
    return std::to_string(std::lround(share * images_per_s)) + " times a second";
  };
  if (sent.color_share < 1.0)
    add("colour comes " + times(sent.color_share));
  else if (sent.jpeg_quality < 100)
    add("colour is less sharp");
  if (sent.whole_factor > 0.0) add(sent.whole_factor > 1.0 ? "depth is coarse" : "depth is near-lossless");
  if (has_window && sent.outside_factor > 1.0) {
    const std::string coarse = sent.outside_factor > 2.0 ? "much coarser" : "coarser";
    const bool is_rare = sent.outside_every > 1;
    add("depth around the hand's window is " + coarse +
        (is_rare ? " and comes " + times(sent.depth_share / sent.outside_every) : std::string()));
  }
  if (sent.depth_share < 1.0) add((has_window ? "exact depth comes " : "depth comes ") + times(sent.depth_share));
  return list;
}

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
    // The content is the one of a moment ago when the rung is new, so what differs is the rung's own guess.
    if (is_new && ratio > 0.5 && ratio < 2.0)
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
  if (taken.video) rate += 125.0 * sent.video_kbit_per_s;
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
