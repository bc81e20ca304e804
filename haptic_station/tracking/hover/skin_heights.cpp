#include "haptic_station/tracking/hover/skin_heights.h"

#include <algorithm>
#include <cmath>

#include "proto/words/numbers/quantile.h"

namespace telepalp::tracking {
namespace {

constexpr int kBlocksAcross = 160;
constexpr int kMostBlock_px = 8;

/// The median of the measured samples of a block; 0 if fewer than half of its pixels are measured.
std::uint16_t median_sample(const DepthImage& depth, int left, int top, int block) noexcept {
  std::array<std::uint16_t, static_cast<std::size_t>(kMostBlock_px) * kMostBlock_px> samples;
  std::size_t measured = 0;
  for (int row = top; row < top + block; ++row)
    for (int column = left; column < left + block; ++column)
      if (const std::uint16_t sample = depth.at(column, row); sample != 0) samples[measured++] = sample;
  if (2 * measured < static_cast<std::size_t>(block) * static_cast<std::size_t>(block) || measured == 0) return 0;
  const std::span seen(samples.data(), measured);
  return median_of(seen);
}

}  // namespace

int SkinHeights::cell(double coordinate_m) noexcept {
  const double at = std::floor(coordinate_m / kCell_m) + kSide / 2;
  return static_cast<int>(std::clamp(at, -1.0, static_cast<double>(kSide)));
}

void SkinHeights::add(const Point<HapticBase>& at) noexcept {
  if (!at.m.allFinite()) return;
  const int column = cell(at.m.x());
  const int row = cell(at.m.z());
  if (column < 0 || column >= kSide || row < 0 || row >= kSide) return;
  float& highest_m = highest_m_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)];
  highest_m = std::max(highest_m, static_cast<float>(at.m.y()));
}

double SkinHeights::highest(const Point<HapticBase>& at, double radius_m) const noexcept {
  float highest_m = kUnseen;
  const int left = std::max(0, cell(at.m.x() - radius_m)), right = std::min(kSide - 1, cell(at.m.x() + radius_m));
  const int top = std::max(0, cell(at.m.z() - radius_m)), bottom = std::min(kSide - 1, cell(at.m.z() + radius_m));
  for (int row = top; row <= bottom; ++row)
    for (int column = left; column <= right; ++column) {
      const double x_m = (column - kSide / 2 + 0.5) * kCell_m - at.m.x();
      const double z_m = (row - kSide / 2 + 0.5) * kCell_m - at.m.z();
      if (x_m * x_m + z_m * z_m > (radius_m + kCell_m) * (radius_m + kCell_m)) continue;
      highest_m =
          std::max(highest_m, highest_m_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)]);
    }
  return static_cast<double>(highest_m);
}

SkinHeights heights_of(const DepthImage& depth, const Intrinsics& camera,
                       const Transform<HapticBase, DepthCamera>& haptic_from_camera) noexcept {
  SkinHeights heights;
  const int block = std::clamp(depth.width / kBlocksAcross, 1, kMostBlock_px);
  for (int top = 0; top + block <= depth.height; top += block)
    for (int left = 0; left + block <= depth.width; left += block) {
      const double z_m = median_sample(depth, left, top, block) * depth.unit_m;
      if (z_m <= 0.0) continue;
      const double u = left + 0.5 * (block - 1), v = top + 0.5 * (block - 1);
      heights.add(haptic_from_camera *
                  Point<DepthCamera>{{(u - camera.cx) / camera.fx * z_m, (v - camera.cy) / camera.fy * z_m, z_m}});
    }
  return heights;
}

}  // namespace telepalp::tracking
