#include "server/capture/synthetic/shape/image_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proto/words/demand.h"

namespace telepalp::server {
namespace {

/// The four cubic B-spline weights at fraction `t` of a cell, and their derivatives.
struct Basis {
  std::array<double, 4> weight;
  std::array<double, 4> slope;
};
Basis basis(double t) noexcept {
  const double s = 1.0 - t;
  return {{s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
           t * t * t / 6.0},
          {-s * s / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, -(3.0 * s * s - 4.0 * s) / 2.0, t * t / 2.0}};
}

}  // namespace

ImageField::ImageField(int width, int height, std::vector<float> control)
    : width_(width), height_(height), control_(std::move(control)) {
  demand(control_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one value a pixel");
}

ImageField::Sample ImageField::at(double u, double v) const noexcept {
  const double column = std::floor(std::clamp(u, -2.0, width_ + 1.0));
  const double row = std::floor(std::clamp(v, -2.0, height_ + 1.0));
  const Basis across = basis(std::clamp(u - column, 0.0, 1.0));
  const Basis down = basis(std::clamp(v - row, 0.0, 1.0));
  Sample sample;
  for (int j = 0; j < 4; ++j) {
    const int y = std::clamp(static_cast<int>(row) + j - 1, 0, height_ - 1);
    double value = 0.0;
    double slope = 0.0;
    for (int i = 0; i < 4; ++i) {
      const int x = std::clamp(static_cast<int>(column) + i - 1, 0, width_ - 1);
      const double control =
          control_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
      value += across.weight[static_cast<std::size_t>(i)] * control;
      slope += across.slope[static_cast<std::size_t>(i)] * control;
    }
    sample.value += down.weight[static_cast<std::size_t>(j)] * value;
    sample.du += down.weight[static_cast<std::size_t>(j)] * slope;
    sample.dv += down.slope[static_cast<std::size_t>(j)] * value;
  }
  return sample;
}

}  // namespace telepalp::server
