#pragma once

namespace telepalp::bench::hand {

/// The height of a hand over the skin at full exhale [m], and its speed [m/s].
struct Height {
  double m = 0.0;
  double m_per_s = 0.0;
};

inline constexpr double kTaps_hz = 4.0;

/// A hand that percusses from `from_s` on: four taps a second, 10 mm deep, which pass the height of the skin at 0.6
/// m/s. Before that, the hand rests at its highest place.
[[nodiscard]] Height tapping(double time_s, double from_s) noexcept;

}  // namespace telepalp::bench::hand
