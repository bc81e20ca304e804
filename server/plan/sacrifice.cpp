#include "server/plan/sacrifice.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "proto/words/numbers/fixed_text.h"
#include "server/plan/rungs.h"

namespace telepalp::plan {
namespace {

constexpr Nanoseconds kToldFor = std::chrono::seconds(3);

std::string in_Mbit_per_s(double B_per_s) { return fixed_text(8e-6 * B_per_s) + " Mbit/s"; }

std::string times_a_second(double images_per_s) {
  return std::to_string(std::lround(images_per_s)) + " times a second";
}

/// "much coarser and comes 5 times a second".
std::string depth_around_window(const ImageSettings& sent, double images_per_s) {
  const std::string coarse = sent.outside_factor > 2.0 ? "much coarser" : "coarser";
  if (sent.outside_every <= 1) return coarse;
  return coarse + " and comes " + times_a_second(sent.depth_share / sent.outside_every * images_per_s);
}

/// "colour comes 10 times a second, depth around the hand's window is coarser". `has_window`: `sent` is depth with a
/// window, which stays exact in the window.
std::string given_up(const ImageSettings& sent, double images_per_s, bool has_window) {
  std::string list;
  const auto add = [&](const std::string& what) { list += (list.empty() ? "" : ", ") + what; };
  if (sent.color_share < 1.0)
    add("colour comes " + times_a_second(sent.color_share * images_per_s));
  else if (sent.jpeg_quality < 100)
    add("colour is less sharp");
  if (sent.whole_factor > 0.0) add(sent.whole_factor > 1.0 ? "depth is coarse" : "depth is near-lossless");
  if (has_window && sent.outside_factor > 1.0)
    add("depth around the hand's window is " + depth_around_window(sent, images_per_s));
  if (sent.depth_share < 1.0)
    add((has_window ? "exact depth comes " : "depth comes ") + times_a_second(sent.depth_share * images_per_s));
  return list;
}

std::string given_up_for_hand(const Sacrifice& sacrifice) {
  if (sacrifice.touch_rung == 0) return "";
  const std::string line =
      "the line to the station carries about " + in_Mbit_per_s(sacrifice.hand_B_per_s.value_or(0.0)) + " of images";
  if (sacrifice.too_thin_to_touch)
    return "too thin to touch: " + line + ", not enough for exact depth 15 times a second";
  return line + "; given up: " + given_up(touch_rungs()[sacrifice.touch_rung].settings, sacrifice.images_per_s, true);
}

std::string given_up_for_viewers(const Sacrifice& sacrifice) {
  if (!sacrifice.viewer_B_per_s || sacrifice.view_rung == 0) return "";
  return "the line to a viewer carries about " + in_Mbit_per_s(*sacrifice.viewer_B_per_s) +
         " of images; given up there: " +
         given_up(view_rungs()[sacrifice.view_rung].settings, sacrifice.images_per_s, false);
}

/// True if both have the same sentence but for the rates.
bool is_told_alike(const Sacrifice& a, const Sacrifice& b) {
  const auto view_rung = [](const Sacrifice& one) { return one.viewer_B_per_s ? one.view_rung : 0; };
  return a.touch_rung == b.touch_rung && a.too_thin_to_touch == b.too_thin_to_touch && view_rung(a) == view_rung(b);
}

}  // namespace

std::string in_words(const Sacrifice& sacrifice) {
  const std::string hand = given_up_for_hand(sacrifice);
  const std::string viewers = given_up_for_viewers(sacrifice);
  return hand + (hand.empty() || viewers.empty() ? "" : "; ") + viewers;
}

void SacrificeNotice::step(const Sacrifice& sacrifice, SessionTime now) {
  if (is_told_alike(sacrifice, told_)) return;
  std::string text = in_words(sacrifice);
  if (!text.empty() && !text_.empty() && now - told_at_ < kToldFor) return;
  text_ = std::move(text);
  told_ = sacrifice;
  told_at_ = now;
}

}  // namespace telepalp::plan
