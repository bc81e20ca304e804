#include "tests/bench/thin/ssim.h"

#include <cstddef>
#include <vector>

#include "proto/words/demand.h"

namespace telepalp::bench {
namespace {

constexpr std::size_t kWindow = 8;
constexpr std::size_t kStep = 4;
constexpr double kC1 = 0.01 * 255 * 0.01 * 255;
constexpr double kC2 = 0.03 * 255 * 0.03 * 255;

std::vector<float> luma_of(const ColorImage& color) {
  std::vector<float> luma(color.rgb.size() / 3);
  for (std::size_t i = 0; i < luma.size(); ++i)
    luma[i] = 0.299F * static_cast<float>(color.rgb[3 * i]) + 0.587F * static_cast<float>(color.rgb[3 * i + 1]) +
              0.114F * static_cast<float>(color.rgb[3 * i + 2]);
  return luma;
}

double ssim_of_window(const float* a, const float* b, std::size_t stride) {
  double sum_a = 0.0, sum_b = 0.0, sum_aa = 0.0, sum_bb = 0.0, sum_ab = 0.0;
  for (std::size_t row = 0; row < kWindow; ++row)
    for (std::size_t i = row * stride; i < row * stride + kWindow; ++i) {
      const double va = double{a[i]};
      const double vb = double{b[i]};
      sum_a += va;
      sum_b += vb;
      sum_aa += va * va;
      sum_bb += vb * vb;
      sum_ab += va * vb;
    }
  constexpr double kCount = kWindow * kWindow;
  const double mean_a = sum_a / kCount;
  const double mean_b = sum_b / kCount;
  const double var_a = (sum_aa - sum_a * mean_a) / (kCount - 1.0);
  const double var_b = (sum_bb - sum_b * mean_b) / (kCount - 1.0);
  const double covariance = (sum_ab - sum_a * mean_b) / (kCount - 1.0);
  return (2.0 * mean_a * mean_b + kC1) * (2.0 * covariance + kC2) /
         ((mean_a * mean_a + mean_b * mean_b + kC1) * (var_a + var_b + kC2));
}

}  // namespace

double ssim(const ColorImage& a, const ColorImage& b) {
  const auto width = static_cast<std::size_t>(a.width);
  const auto height = static_cast<std::size_t>(a.height);
  demand(a.rgb.size() == b.rgb.size() && a.width == b.width && width >= kWindow && height >= kWindow,
         "images are compared with others of their size");
  const std::vector<float> luma_a = luma_of(a);
  const std::vector<float> luma_b = luma_of(b);
  double sum = 0.0;
  double windows = 0.0;
  for (std::size_t row = 0; row + kWindow <= height; row += kStep)
    for (std::size_t column = 0; column + kWindow <= width; column += kStep, windows += 1.0)
      sum += ssim_of_window(&luma_a[row * width + column], &luma_b[row * width + column], width);
  return sum / windows;
}

}  // namespace telepalp::bench
