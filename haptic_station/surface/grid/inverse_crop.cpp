#include "haptic_station/surface/grid/inverse_crop.h"

#include <algorithm>

namespace telepalp::surface {
namespace {

/// A reference for the inverse depths of the crop: any measured one. The differences are small, and so is their
/// rounding.
float reference_in(const DepthField& depth, const InverseCrop& crop) {
  constexpr int kEvery = 7;
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < crop.height; row += kEvery)
    for (int column = 0; column < crop.width; column += kEvery)
      if (const float z = depth.z_m[depth.index(crop.left + column, crop.top + row)]; z > 0.0F) {
        sum += 1.0 / static_cast<double>(z);
        ++count;
      }
  return count > 0 ? static_cast<float>(sum / count) : 0.0F;
}

/// Links two neighbouring pixels if both are measured and there is no depth break between them.
void link(InverseCrop& crop) {
  for (int row = 0; row < crop.height; ++row) {
    const std::uint64_t* measured = crop.measured.row(row);
    const std::uint64_t* next = crop.measured.row(std::min(row + 1, crop.height - 1));
    std::uint64_t* right = crop.right.row(row);  // these bits mark depth breaks so far
    std::uint64_t* below = crop.below.row(row);
    for (std::size_t word = 0; word < crop.measured.words(); ++word) {
      const std::uint64_t to_the_right = measured[word] >> 1 | measured[word + 1] << 63;
      right[word] = measured[word] & to_the_right & ~right[word];
      below[word] = measured[word] & next[word] & ~below[word];
    }
  }
}

}  // namespace

InverseCrop crop_of(const DepthField& depth, const PixelBox& box, int margin_px, double break_m) {
  InverseCrop crop(box, depth.width, depth.height, margin_px);
  crop.reference_per_m = reference_in(depth, crop);
  const auto width = static_cast<std::size_t>(crop.width);
  std::vector<std::uint8_t> marks(width);
  for (int row = 0; row < crop.height; ++row) {
    const float* z_m = &depth.z_m[depth.index(crop.left, crop.top + row)];
    const float* below = row + 1 < crop.height ? z_m + depth.width : z_m;
    invert_row(z_m, crop.width, crop.reference_per_m, &crop.per_m[crop.at(0, row)]);
    mark_row(z_m, below, crop.width, static_cast<float>(break_m), marks.data());
    pack_row(marks.data(), crop.width, kMeasured, crop.measured.row(row));
    pack_row(marks.data(), crop.width, kBrokenRight, crop.right.row(row));
    pack_row(marks.data(), crop.width, kBrokenBelow, crop.below.row(row));
    const int* above = &crop.troubles[static_cast<std::size_t>(row) * (width + 1)];
    int* counts = &crop.troubles[static_cast<std::size_t>(row + 1) * (width + 1)];
    int in_row = 0;
    for (std::size_t u = 0; u < width; ++u) {
      in_row += marks[u] == kMeasured ? 0 : 1;
      counts[u + 1] = above[u + 1] + in_row;
    }
  }
  link(crop);
  return crop;
}

}  // namespace telepalp::surface
