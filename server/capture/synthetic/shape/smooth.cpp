#include "server/capture/synthetic/shape/smooth.h"

#include <algorithm>
#include <cmath>

namespace telepalp::capture {
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

void blur_rows(const std::vector<float>& in, std::vector<float>& out, const std::vector<float>& kernel,
               ImageSize size) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  std::vector<float> padded(static_cast<std::size_t>(size.width + 2 * radius));
  for (int row = 0; row < size.height; ++row) {
    const float* from = &in[static_cast<std::size_t>(row * size.width)];
    float* to = &out[static_cast<std::size_t>(row * size.width)];
    for (int i = 0; i < size.width + 2 * radius; ++i)
      padded[static_cast<std::size_t>(i)] = from[std::clamp(i - radius, 0, size.width - 1)];
    std::fill(to, to + size.width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (int i = 0; i < size.width; ++i) to[i] += kernel[k] * padded[static_cast<std::size_t>(i) + k];
  }
}

/// Works row by row, too, so that memory is read in order.
void blur_columns(const std::vector<float>& in, std::vector<float>& out, const std::vector<float>& kernel,
                  ImageSize size) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  for (int row = 0; row < size.height; ++row) {
    float* to = &out[static_cast<std::size_t>(row * size.width)];
    std::fill(to, to + size.width, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const int source = std::clamp(row + static_cast<int>(k) - radius, 0, size.height - 1);
      const float* from = &in[static_cast<std::size_t>(source * size.width)];
      for (int i = 0; i < size.width; ++i) to[i] += kernel[k] * from[i];
    }
  }
}

}  // namespace

std::vector<float> blur(std::vector<float> image, ImageSize size, double sigma_px) {
  const std::vector<float> kernel = gaussian_kernel(sigma_px);
  std::vector<float> across(image.size());
  blur_rows(image, across, kernel, size);
  blur_columns(across, image, kernel, size);
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

}  // namespace telepalp::capture
