#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "proto/words/time.h"

namespace telepalp {

/// The largest image width and height that telepalp accepts; it bounds allocations for images from peers and files.
inline constexpr int kMaxImageSide = 4096;

/// Depth along the optical axis. `samples[row * width + column] * unit_m` is z in metres; 0 means "not measured".
struct DepthImage {
  int width = 0;
  int height = 0;
  double unit_m = 0.001;
  std::vector<std::uint16_t> samples;

  [[nodiscard]] std::uint16_t at(int column, int row) const noexcept {
    return samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

/// 8-bit RGB, rows top to bottom, three bytes a pixel, no padding. Empty when the camera has no colour.
struct ColorImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Pinhole intrinsics [pixels], no distortion: u = fx * x / z + cx, with pixel centres at whole numbers.
struct Intrinsics {
  int width = 0;
  int height = 0;
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;

  friend bool operator==(const Intrinsics&, const Intrinsics&) = default;
};

/// Intrinsics of an RGB-D camera.
struct CameraModel {
  Intrinsics depth;
  Intrinsics color;              ///< equal to `depth` when colour is registered to depth
  bool color_registered = true;  ///< colour pixel (u, v) and depth pixel (u, v) show the same point of the scene
};

/// The error bound of near-lossless depth: a depth z [m] differs from the measurement by at most
/// max(least_m, per_m * z²) [m]; per_m is in 1/m.
struct DepthErrorBound {
  double least_m = 0.0;
  double per_m = 0.0;

  /// The infinite bound: depth may differ from the measurement by an unknown amount.
  [[nodiscard]] static DepthErrorBound unknown() noexcept {
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  [[nodiscard]] double at(double z_m) const noexcept { return std::max(least_m, per_m * z_m * z_m); }
  friend bool operator==(const DepthErrorBound&, const DepthErrorBound&) = default;
};

/// One frame of an RGB-D camera. `captured` is the time of exposure, as accurately as the driver reports it.
struct RgbdFrame {
  SessionTime captured;
  std::uint64_t sequence = 0;
  CameraModel camera;
  DepthImage depth;
  ColorImage color;
  std::optional<DepthErrorBound> loss = {};  ///< bound on the error of earlier depth coding; nullopt: as measured
};

/// True when the sizes agree with each other and lie within kMaxImageSide, and the intrinsics are finite, with positive
/// focal lengths.
[[nodiscard]] bool is_well_formed(const DepthImage& depth) noexcept;
[[nodiscard]] bool is_well_formed(const ColorImage& color) noexcept;
[[nodiscard]] bool is_well_formed(const Intrinsics& intrinsics) noexcept;
[[nodiscard]] bool is_well_formed(const RgbdFrame& frame) noexcept;

}  // namespace telepalp
