#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "proto/words/time.h"

namespace telepalp::plan {

/// What a plan gives up, and the rates of the lines that make it necessary.
struct Sacrifice {
  std::size_t touch_rung = 0;  ///< of touch_rungs()
  std::size_t view_rung = 0;   ///< of view_rungs()
  /// For more than a moment, the hand's line has carried too little for exact depth 15 times a second.
  bool too_thin_to_touch = false;
  std::optional<double> hand_B_per_s{};  ///< budget of the hand's line; nullopt: it has room for everything
  std::optional<double>
      viewer_B_per_s{};        ///< least budget of the viewers' lines; nullopt: each has room for everything
  double images_per_s = 30.0;  ///< of the camera
};

/// For people: "the line to the station carries about 4.0 Mbit/s of images; given up: colour comes 12 times a second".
/// Empty: nothing is given up. What viewers give up for the hand alone is not named.
[[nodiscard]] std::string in_words(const Sacrifice& sacrifice);

/// The sentence that people see of what is given up. Each sentence stays for 3 s, so that it can be read, or until
/// nothing is given up any more. It names the rate of the moment when it was made. Pure.
class SacrificeNotice {
 public:
  void step(const Sacrifice& sacrifice, SessionTime now);
  [[nodiscard]] const std::string& text() const noexcept { return text_; }

 private:
  std::string text_;
  Sacrifice told_{};  ///< in text_
  SessionTime told_at_{};
};

}  // namespace telepalp::plan
