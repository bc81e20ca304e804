#include "clients/mixed/compose/hand_layer.h"

#include <array>
#include <cmath>

namespace telepalp::mixed {
namespace {

/// A colour and its opacity, each interpolated from four pixels.
struct Sample {
  std::array<double, 3> rgb{};  ///< the colour, multiplied by the opacity
  double opacity = 0.0;
};

Sample hand_at(const ColorImage& live, const Mask& hand, double x, double y) {
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const double right_share = x - left, low_share = y - top;
  Sample sample;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column) {
      if (!hand.contains(left + column, top + row) || !hand.at(left + column, top + row)) continue;
      const double share = (column == 0 ? 1.0 - right_share : right_share) * (row == 0 ? 1.0 - low_share : low_share);
      const std::size_t pixel = 3 * hand.index(left + column, top + row);
      for (std::size_t c = 0; c < 3; ++c) sample.rgb[c] += share * live.rgb[pixel + c];
      sample.opacity += share;
    }
  return sample;
}

void blend(ColorImage& image, std::size_t pixel, const Sample& over, double weight) {
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint8_t& level = image.rgb[3 * pixel + c];
    level = static_cast<std::uint8_t>(std::lround((1.0 - weight * over.opacity) * level + weight * over.rgb[c]));
  }
}

}  // namespace

void draw_hand(ColorImage& image, const ColorImage& live, const Mask& hand, const GraspingArea& grasp,
               const Eigen::Vector2d& shift_px) {
  const Box still = box_of(hand);
  if (still.empty()) return;
  const int reach_px = static_cast<int>(std::min(std::ceil(shift_px.cwiseAbs().maxCoeff()), 1.0 * kMaxImageSide)) + 1;
  const Box box = still.grown(reach_px, hand.width, hand.height);

  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x) {
      const std::size_t pixel = hand.index(x, y);
      if (hand.at(x, y)) {
        const double arm = 1.0 - grasp.weight_at(Eigen::Vector2d(x, y));
        const std::uint8_t* const rgb = live.rgb.data() + 3 * pixel;
        if (arm > 0.0) blend(image, pixel, {{1.0 * rgb[0], 1.0 * rgb[1], 1.0 * rgb[2]}, 1.0}, arm);
      }
      const Eigen::Vector2d from = Eigen::Vector2d(x, y) - shift_px;
      const Sample moved = hand_at(live, hand, from.x(), from.y());
      if (moved.opacity <= 0.0) continue;
      const double weight = grasp.weight_at(from);
      if (weight > 0.0) blend(image, pixel, moved, weight);
    }
}

}  // namespace telepalp::mixed
