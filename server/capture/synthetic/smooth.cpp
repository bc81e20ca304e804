#include "server/capture/synthetic/smooth.h"

#include <algorithm>
#include <cmath>

namespace telepalp::server {
namespace {

std::vector<float> gaussian_kernel(double sigma_px) {
  const int radius = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_px)));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * (i / sigma_px) * (i / sigma_px))));
    sum += kernel.back();
  }
  for (float& weight : kernel) weight /= sum;
  return kernel;
}

/// One direction of the separable blur, over lines of `length` samples `step` apart.
void blur_lines(const std::vector<float>& in, std::vector<float>& out, const std::vector<float>& kernel, int lines,
                int line_step, int length, int step) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  for (int line = 0; line < lines; ++line)
    for (int i = 0; i < length; ++i) {
      float sum = 0.0F;
      for (int k = -radius; k <= radius; ++k)
        sum += kernel[static_cast<std::size_t>(k + radius)] *
               in[static_cast<std::size_t>(line * line_step + std::clamp(i + k, 0, length - 1) * step)];
      out[static_cast<std::size_t>(line * line_step + i * step)] = sum;
    }
}

}  // namespace

std::vector<float> blur(std::vector<float> image, ImageSize size, double sigma_px) {
  const std::vector<float> kernel = gaussian_kernel(sigma_px);
  std::vector<float> across(image.size());
  blur_lines(image, across, kernel, size.height, size.width, size.width, 1);
  blur_lines(across, image, kernel, size.width, 1, size.height, size.width);
  return image;
}

std::vector<float> masked_blur(const std::vector<float>& image, const std::vector<float>& mask, ImageSize size,
                               double sigma_px, float elsewhere) {
  std::vector<float> weighted(image.size());
  for (std::size_t i = 0; i < image.size(); ++i) weighted[i] = mask[i] * image[i];
  weighted = blur(std::move(weighted), size, sigma_px);
  const std::vector<float> weight = blur(mask, size, sigma_px);
  for (std::size_t i = 0; i < image.size(); ++i) weighted[i] = weight[i] > 1e-3F ? weighted[i] / weight[i] : elsewhere;
  return weighted;
}

}  // namespace telepalp::server
