#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "codec/depth.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::codec_tool {

/// Accumulates the differences between depth images and their originals over all pixels.
class DepthDifference {
 public:
  /// `bound`: allowed difference of a pixel, as a function of its original depth; nullopt: no limit.
  explicit DepthDifference(const std::optional<DepthErrorBound>& bound = {}) : bound_(bound) {}

  /// Compares two images of equal size.
  void add(const DepthImage& original, const DepthImage& other);

  [[nodiscard]] std::size_t measured() const noexcept { return measured_; }  ///< pixels measured in both images
  [[nodiscard]] std::size_t flips() const noexcept { return flips_; }        ///< pixels measured in one image only
  [[nodiscard]] double worst_mm() const noexcept { return worst_mm_; }
  [[nodiscard]] double rms_mm() const;

  /// Number of pixels beyond the bound, including pixels measured in one image only; 0 without a bound.
  [[nodiscard]] std::size_t beyond() const noexcept { return beyond_; }
  /// Position and difference of the first pixel beyond the bound: "frame 3, column 17, row 20 (counted from 0) at
  /// 800.000 mm: off by 4.000 mm, 2.850 mm allowed".
  [[nodiscard]] const std::string& first_beyond() const noexcept { return first_beyond_; }

 private:
  void hold(const DepthImage& original, const DepthImage& other, std::size_t pixel);

  std::optional<DepthErrorBound> bound_;
  std::size_t frames_ = 0;
  std::size_t measured_ = 0;
  std::size_t flips_ = 0;
  std::size_t beyond_ = 0;
  double worst_mm_ = 0.0;
  double squares_mm2_ = 0.0;
  std::string first_beyond_;
};

}  // namespace telepalp::codec_tool
