#pragma once

#include <cstddef>
#include <vector>

namespace telepalp::capture {

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// Gaussian blur of `sigma_px`; beyond the border, the border pixels repeat.
[[nodiscard]] std::vector<float> blur(std::vector<float> image, ImageSize size, double sigma_px);

/// Normalised Gaussian blur: each pixel becomes the weighted mean of the pixels with `mask` 1. Pixels farther than
/// about three sigma from all of these become `elsewhere`.
[[nodiscard]] std::vector<float> masked_blur(const std::vector<float>& image, const std::vector<float>& mask,
                                             ImageSize size, double sigma_px, float elsewhere);

}  // namespace telepalp::capture
