#pragma once

#include <Eigen/Core>
#include <vector>

namespace telepalp::capture {

/// A smooth scalar over the image plane: a uniform cubic B-spline (twice continuously differentiable) with its control
/// values at the pixel centres. Control values beyond the border equal the nearest one at the border.
class ImageField {
 public:
  struct Sample {
    double value = 0.0;
    double du = 0.0;  ///< derivative to the right, per pixel
    double dv = 0.0;  ///< derivative downwards, per pixel
  };

  ImageField() = default;
  ImageField(int width, int height, std::vector<float> control);

  /// Evaluates the field at finite pixel coordinates (u, v); pixel centres have integer coordinates.
  [[nodiscard]] Sample at(double u, double v) const noexcept;

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<float> control_;
};

}  // namespace telepalp::capture
