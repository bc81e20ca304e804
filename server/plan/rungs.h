#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "server/plan/grade.h"

namespace telepalp::plan {

/// One step of an order of sacrifice: what is still sent, and a first guess of its size.
struct Rung {
  ImageSettings settings{};
  double depth_bytes = 1.0;    ///< first guess: bytes of a depth image, over those at rung 0
  double picture_bytes = 1.0;  ///< first guess: bytes of a picture (JPEG), over those at rung 0
};

/// What is given up for the hand, rung after rung: first the rate of colour, then the exactness of depth around the
/// window, then the rate of that depth, then more of colour. The exact depth in the window comes last: its rate falls
/// to 15 Hz of a 30 Hz camera, and below that only at the last rung.
[[nodiscard]] std::span<const Rung> touch_rungs() noexcept;

/// True at a rung of touch_rungs() that sends exact depth fewer than 15 times a second of a 30 Hz camera.
[[nodiscard]] constexpr bool is_too_thin_to_touch(const Rung& rung) noexcept { return rung.settings.depth_share < 0.5; }

/// What is given up for viewers, rung after rung: first colour, then the exactness of depth, then its rate.
[[nodiscard]] std::span<const Rung> view_rungs() noexcept;

/// The last rung of view_rungs() that gives up colour alone: it has the exact depth of each image.
[[nodiscard]] std::size_t color_given_up() noexcept;

inline constexpr double kBytesPerKbit = 125.0;

/// What a subscriber takes of the camera's images.
struct Taken {
  double images_per_s = 30.0;  ///< of the camera
  bool depth = false;
  bool pictures = false;
  bool video = false;
};

/// The bytes of images at each rung, learnt from the images that were made. The guesses for the other rungs keep their
/// ratios to the measured one.
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
  /// Share of the camera's images whose depth is sent at `rung`: that of the table, raised as far as `rest_B_per_s`,
  /// which the rung leaves of the budget, allows, but at most to the share of the rung before.
  [[nodiscard]] double depth_share(std::size_t rung, const Taken& taken, double rest_B_per_s) const noexcept;
  /// The first rung whose rate is at most `budget_B_per_s`; the last rung if no rate is. A rung before `present` must
  /// fit with a margin, so that the plan does not go back and forth between two rungs.
  [[nodiscard]] std::size_t fitting(double budget_B_per_s, const Taken& taken, std::size_t present) const noexcept;

 private:
  std::span<const Rung> rungs_;
  std::vector<double> depth_B_, picture_B_;  // by rung
  std::size_t last_ = 0;                     // the rung of the last measured()
};

}  // namespace telepalp::plan
