#include "server/capture/synthetic/shape/image_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "proto/words/demand.h"
#include "proto/words/numbers/cubic_b_spline.h"

namespace telepalp::capture {
ImageField::ImageField(int width, int height, std::vector<float> control)
    : width_(width), height_(height), control_(std::move(control)) {
  demand(control_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
         "an image field has one value for each pixel");
}

ImageField::Sample ImageField::at(double u, double v) const noexcept {
  const double column = std::floor(std::clamp(u, -2.0, width_ + 1.0));
  const double row = std::floor(std::clamp(v, -2.0, height_ + 1.0));
  const CubicBSpline<double> across = cubic_b_spline(std::clamp(u - column, 0.0, 1.0));
  const CubicBSpline<double> down = cubic_b_spline(std::clamp(v - row, 0.0, 1.0));
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

}  // namespace telepalp::capture
