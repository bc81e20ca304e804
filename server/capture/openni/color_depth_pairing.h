#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// Pairs the separate depth and colour streams of a camera by driver time stamps. A depth image waits at most
/// kWaitForColor for its colour image. The next depth image replaces one that take() has not fetched.
class ColorDepthPairing {
 public:
  struct Pair {
    std::chrono::microseconds driver_time{};  ///< of the depth image
    SessionTime arrival;                      ///< of the depth image
    DepthImage depth;
    ColorImage color;  ///< empty when no colour image lies within kStaleColor
  };

  static constexpr std::chrono::microseconds kSameInstant{17'000};  ///< longest time between a pair's images: 1/60 s
  static constexpr std::chrono::microseconds kStaleColor{200'000};
  static constexpr Nanoseconds kWaitForColor{15'000'000};

  void add_color(std::chrono::microseconds driver_time, ColorImage color);
  void add_depth(std::chrono::microseconds driver_time, SessionTime arrival, DepthImage depth);

  /// Returns the depth image with the colour image within kSameInstant. After kWaitForColor, it returns the depth image
  /// with the newest colour image, or without colour if the driver's time stamps of the two images differ by more than
  /// kStaleColor. nullopt: there is no depth image, or the depth image still waits for its colour image.
  [[nodiscard]] std::optional<Pair> take(SessionTime now);

  /// True while a depth image waits for its colour image or for take().
  [[nodiscard]] bool waiting() const noexcept { return depth_.has_value(); }

 private:
  [[nodiscard]] bool color_within(std::chrono::microseconds reach) const;

  std::optional<std::pair<std::chrono::microseconds, ColorImage>> color_;
  std::optional<Pair> depth_;
};

}  // namespace telepalp::capture
