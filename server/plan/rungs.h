#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "server/plan/grade.h"

namespace telepalp::plan {

/// One step of an order of sacrifice: what is still sent, and about how many bytes that takes.
struct Rung {
  ImageSettings settings{};
  double depth_bytes = 1.0;    ///< first guess of a depth image's bytes, as a share of those at rung 0
  double picture_bytes = 1.0;  ///< the same of a picture's (JPEG)
};

/// What is given up for a station that takes depth with a window, first things first: colour's rate, then the depth
/// around the window, then the rate of that depth, then more of colour. The depth in the window comes last: its rate
/// falls to 15 Hz, and at the last rung below, which is too thin to touch.
[[nodiscard]] std::span<const Rung> touch_rungs() noexcept;
inline constexpr std::size_t kTooThinToTouch = 14;  ///< the rung of touch_rungs() at which the window falls below 15 Hz

/// What is given up for viewers: colour first, then the exactness of depth, then its rate.
[[nodiscard]] std::span<const Rung> view_rungs() noexcept;
inline constexpr std::size_t kColorGivenUp = 3;  ///< the rung of view_rungs() that still has exact depth at full rate

/// What `sent` gives up, for people: "colour comes 10 times a second, depth around the hand's window is coarser".
/// `images_per_s`: of the camera. `has_window`: of depth with a window, which stays exact there.
[[nodiscard]] std::string given_up(const ImageSettings& sent, double images_per_s, bool has_window);

/// Rates of what a subscriber takes.
struct Taken {
  double images_per_s = 30.0;  ///< of the camera
  bool depth = false;
  bool pictures = false;
  bool video = false;
};

/// The bytes of images at each rung, learnt from those that were made. Guesses for the other rungs keep their ratio to
/// what was measured at the present one.
class RungBytes {
 public:
  struct FirstGuess {
    double depth_B = 0.0;
    double picture_B = 0.0;
  };
  /// `rungs` must outlive this object. `at_full`: bytes of an image at rung 0, until one was made.
  RungBytes(std::span<const Rung> rungs, const FirstGuess& at_full);

  /// `depth_B`, `picture_B`: mean bytes of the images that were made at `rung`; 0: none was made.
  void measured(std::size_t rung, double depth_B, double picture_B) noexcept;
  /// Rate of the images at `rung` [B/s].
  [[nodiscard]] double rate_B_per_s(std::size_t rung, const Taken& taken) const noexcept;
  /// What `rung` sends, with as much of `rest_B_per_s` for the rate of depth as the rung before would allow.
  [[nodiscard]] double depth_share(std::size_t rung, const Taken& taken, double rest_B_per_s) const noexcept;
  /// The first rung, in the order of sacrifice, whose rate is at most `budget_B_per_s`; the last if there is none. A
  /// rung above `present` must leave a margin, so that the plan stays where it is.
  [[nodiscard]] std::size_t fitting(double budget_B_per_s, const Taken& taken, std::size_t present) const noexcept;

 private:
  std::span<const Rung> rungs_;
  std::vector<double> depth_B_, picture_B_;  // by rung
  std::size_t last_ = 0;
};

/// Rate of colour as video if nothing is given up; the server's default.
inline constexpr int kFullVideo_kbit_per_s = 800;

}  // namespace telepalp::plan
