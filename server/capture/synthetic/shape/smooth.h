#pragma once

#include <cstddef>
#include <vector>

namespace telepalp::server {

struct ImageSize {
  int width = 0;
  int height = 0;
};

/// Gaussian blur of `sigma_px`, the border repeated.
[[nodiscard]] std::vector<float> blur(std::vector<float> image, ImageSize size, double sigma_px);

/// Gaussian blur of those pixels whose `mask` is 1, spread a few pixels beyond them; `elsewhere` where none is near.
[[nodiscard]] std::vector<float> masked_blur(const std::vector<float>& image, const std::vector<float>& mask,
                                             ImageSize size, double sigma_px, float elsewhere);

}  // namespace telepalp::server
