#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// Joins the two streams of a camera, which arrive each on its own, by their driver timestamps. Depth leads: it is
/// never dropped for want of colour, only waits for it a little.
class ColorDepthPairing {
 public:
  struct Pair {
    std::chrono::microseconds driver_time{};  ///< of the depth
    SessionTime arrival;                      ///< of the depth
    DepthImage depth;
    ColorImage color;  ///< empty when there was none within kStaleColor
  };

  static constexpr std::chrono::microseconds kSameInstant{17'000};  ///< half a period at 30 Hz
  static constexpr std::chrono::microseconds kStaleColor{200'000};
  static constexpr Nanoseconds kWaitForColor{15'000'000};

  void add_color(std::chrono::microseconds driver_time, ColorImage color);
  void add_depth(std::chrono::microseconds driver_time, SessionTime arrival, DepthImage depth);

  /// The pair that is ready at `now`, with its colour, or, when colour does not come, with the last one.
  [[nodiscard]] std::optional<Pair> take(SessionTime now);

  /// True while a depth image waits for its colour.
  [[nodiscard]] bool waiting() const noexcept { return depth_.has_value(); }

 private:
  [[nodiscard]] bool color_within(std::chrono::microseconds reach) const;

  std::optional<std::pair<std::chrono::microseconds, ColorImage>> color_;
  std::optional<Pair> depth_;
};

}  // namespace telepalp::server
