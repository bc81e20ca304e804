#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// Three planes of samples: luma, and two of chroma with half the width and height, rounded up.
struct PlaneRows {
  std::array<const std::uint8_t*, 3> first{};
  std::array<int, 3> stride{};  ///< bytes from a row to the next
};

/// Converts RGB to the planes that VP8 codes (ITU-R BT.601, luma from 16 to 235), and back. It keeps its buffers, so
/// that a stream allocates them once.
class YuvConverter {
 public:
  YuvConverter();
  ~YuvConverter();
  YuvConverter(YuvConverter&&) noexcept;
  YuvConverter& operator=(YuvConverter&&) noexcept;

  /// The planes of `color`, which is well formed and not empty. They are valid until the next call.
  [[nodiscard]] PlaneRows planes_of(const ColorImage& color);

  /// The image of these planes.
  [[nodiscard]] ColorImage color_of(const PlaneRows& planes, int width, int height);

 private:
  struct Turbo;
  std::unique_ptr<Turbo> turbo_;
  std::array<std::vector<std::uint8_t>, 3> planes_;
};

}  // namespace telepalp::codec
