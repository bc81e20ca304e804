#include "haptic_station/surface/temporal_filter.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

constexpr int kCell = MotionField::kCell_px;
constexpr float kFloor_m = 2e-4F;  // of the noise: rounding
constexpr float kOutlier = 5.0F;   // sigmas between a pixel and its average, at most
constexpr float kPatchOutlier = 4.5F;
constexpr float kUnseenKeep = 0.7F;  // of a pixel's frames, for each frame without it
constexpr float kStartAnew_frames = 4.0F;

/// Axial noise of a structured-light camera [m], as in node_fit.
float noise_m(float z_m) noexcept { return 0.0012F + 0.0019F * (z_m - 0.4F) * (z_m - 0.4F); }

/// Values at cell centres, spread linearly over one row of pixels.
void spread_over_row(const std::vector<float>& cells, int columns, int rows, int row, std::vector<float>& out) {
  const float y = std::clamp((static_cast<float>(row) + 0.5F) / kCell - 0.5F, 0.0F, static_cast<float>(rows - 1));
  const int top = std::min(static_cast<int>(y), std::max(0, rows - 2));
  const float fy = y - static_cast<float>(top);
  const float* above = &cells[static_cast<std::size_t>(top * columns)];
  const float* below = rows > 1 ? above + columns : above;
  const auto at_cell = [&](int column) {
    const int c = std::clamp(column, 0, columns - 1);
    return above[c] + fy * (below[c] - above[c]);
  };
  const int width = static_cast<int>(out.size());
  for (int column = -1; column < columns; ++column) {
    const float left = at_cell(column);
    const float slope = (at_cell(column + 1) - left) / kCell;
    const int centre = column * kCell + kCell / 2;  // pixel half a pixel right of the cell's centre
    const int from = std::max(0, centre);
    const int to = std::min(width, centre + kCell);
    for (int u = from; u < to; ++u)
      out[static_cast<std::size_t>(u)] = left + slope * (static_cast<float>(u - centre) + 0.5F);
  }
}

}  // namespace

TemporalFilter::TemporalFilter(int width, int height, const SurfaceSettings& settings)
    : motion_(width, height, settings.breathing),
      memory_frames_(static_cast<float>(std::max(1.0, settings.memory_frames))) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  average_ = {.width = width,
              .height = height,
              .z_m = std::vector<float>(count, 0.0F),
              .weight = std::vector<float>(count, 0.0F)};
  change_at_.resize(static_cast<std::size_t>(width));
  correction_at_.resize(static_cast<std::size_t>(width));
  innovation_at_.resize(static_cast<std::size_t>(width));
  seen_.resize(static_cast<std::size_t>(motion_.columns()) * static_cast<std::size_t>(motion_.rows()));
  const std::size_t patches = static_cast<std::size_t>((width + kPatch_px - 1) / kPatch_px) *
                              static_cast<std::size_t>((height + kPatch_px - 1) / kPatch_px);
  patch_sum_.assign(patches, 0.0F);
  patch_count_.assign(patches, 0.0F);
  patch_mean_.assign(patches, 0.0F);
}

const DepthField& TemporalFilter::add(const DepthField& seen, double dt_s) {
  if (first_) {
    first_ = false;
    average_.z_m = seen.z_m;
    std::transform(seen.z_m.begin(), seen.z_m.end(), average_.weight.begin(),
                   [](float z) { return z > 0.0F ? 1.0F : 0.0F; });
    return average_;
  }
  change_ = &motion_.predict(dt_s);
  observe(seen);
  correction_ = &motion_.correct(seen_, dt_s);
  update(seen);
  watch_patches();
  return average_;
}

/// Mean innovation of each cell, from every other pixel.
void TemporalFilter::observe(const DepthField& seen) {
  std::fill(seen_.begin(), seen_.end(), CellInnovation{});
  noise_sum_ = noise_count_ = 0.0;
  for (int row = 0; row < seen.height; ++row) {
    spread_over_row(*change_, motion_.columns(), motion_.rows(), row, change_at_);
    CellInnovation* cells = &seen_[static_cast<std::size_t>((row / kCell) * motion_.columns())];
    const std::size_t start = seen.index(0, row);
    for (int left = 0; left < seen.width; left += kCell) {
      float sum = 0.0F;
      float spread = 0.0F;
      float sigmas = 0.0F;
      int count = 0;
      for (int u = left + row % 2; u < std::min(left + kCell, seen.width); u += 2) {
        const std::size_t at = start + static_cast<std::size_t>(u);
        const float z = seen.z_m[at];
        const float expected = average_.z_m[at] + change_at_[static_cast<std::size_t>(u)];
        const float r = z - expected;
        const float sigma = std::max(kFloor_m, noise_m(expected) * noise_scale_);
        if (z <= 0.0F || average_.z_m[at] <= 0.0F || std::abs(r) > 2.0F * kOutlier * sigma) continue;
        sum += r;
        spread += std::abs(r) / noise_m(expected);
        sigmas += sigma;
        ++count;
      }
      CellInnovation& cell = cells[left / kCell];
      cell.mean_m += static_cast<double>(sum);
      cell.count += count;
      cell.sigma_m += static_cast<double>(sigmas);
      noise_sum_ += static_cast<double>(spread);
      noise_count_ += count;
    }
  }
  for (CellInnovation& cell : seen_) {
    cell.mean_m /= std::max(cell.count, 1.0);
    cell.sigma_m /= std::pow(std::max(cell.count, 1.0), 1.5);  // mean sigma over the root of the count
  }
  if (noise_count_ > 100.0)
    noise_scale_ += 0.05F * (static_cast<float>(1.2533 * noise_sum_ / noise_count_) - noise_scale_);
}

void TemporalFilter::update(const DepthField& seen) {
  const int patches_across = (seen.width + kPatch_px - 1) / kPatch_px;
  for (int row = 0; row < seen.height; ++row) {
    spread_over_row(*change_, motion_.columns(), motion_.rows(), row, change_at_);
    spread_over_row(*correction_, motion_.columns(), motion_.rows(), row, correction_at_);
    spread_over_row(motion_.innovations(), motion_.columns(), motion_.rows(), row, innovation_at_);
    const std::size_t start = seen.index(0, row);
    float* patch_sum = &patch_sum_[static_cast<std::size_t>((row / kPatch_px) * patches_across)];
    float* patch_count = &patch_count_[static_cast<std::size_t>((row / kPatch_px) * patches_across)];
    for (int u = 0; u < seen.width; ++u) {
      const std::size_t at = start + static_cast<std::size_t>(u);
      const float z = seen.z_m[at];
      float& average = average_.z_m[at];
      float& frames = average_.weight[at];
      if (average <= 0.0F) {
        average = z;
        frames = z > 0.0F ? 1.0F : 0.0F;
        continue;
      }
      const float moved =
          average + change_at_[static_cast<std::size_t>(u)] + correction_at_[static_cast<std::size_t>(u)];
      if (z <= 0.0F) {
        frames *= kUnseenKeep;
        average = frames > 0.5F ? moved : 0.0F;
        continue;
      }

      const float r = z - moved;
      const float sigma = std::max(kFloor_m, noise_m(moved) * noise_scale_);
      if (std::abs(r) > kOutlier * sigma) {
        frames *= 0.4F;
        const bool anew = frames < 1.0F;
        average = anew ? z : moved;
        frames = anew ? 1.0F : frames;
        continue;
      }
      frames = std::min(frames + 1.0F, memory_frames_);
      average = moved + r / frames;
      patch_sum[u / kPatch_px] += r / (sigma * std::sqrt(1.0F + 2.0F / frames));  // the average errs as well
      patch_count[u / kPatch_px] += 1.0F;
    }
  }
}

/// A patch whose residuals lean to one side is moving in a way that no cell knows: its pixels start anew.
void TemporalFilter::watch_patches() {
  const int across = (average_.width + kPatch_px - 1) / kPatch_px;
  for (std::size_t patch = 0; patch < patch_mean_.size(); ++patch) {
    const float count = patch_count_[patch];
    const float mean = count > 0.0F ? patch_sum_[patch] / std::sqrt(count) : 0.0F;  // unit variance by chance
    patch_sum_[patch] = patch_count_[patch] = 0.0F;
    patch_mean_[patch] = 0.5F * (patch_mean_[patch] + mean);
    if (std::abs(patch_mean_[patch]) < kPatchOutlier * 0.577F) continue;  // sqrt(1/3): of a running mean of halves
    const int left = static_cast<int>(patch % static_cast<std::size_t>(across)) * kPatch_px;
    const int top = static_cast<int>(patch / static_cast<std::size_t>(across)) * kPatch_px;
    for (int row = top; row < std::min(top + kPatch_px, average_.height); ++row)
      for (int column = left; column < std::min(left + kPatch_px, average_.width); ++column) {
        float& frames = average_.weight[average_.index(column, row)];
        frames = std::min(frames, kStartAnew_frames);
      }
  }
}

void fill_pinholes(DepthField& depth, double break_at_1m) {
  const auto limit = static_cast<float>(break_at_1m);
  const auto width = static_cast<std::size_t>(depth.width);
  for (int row = 1; row + 1 < depth.height; ++row)
    for (int column = 1; column + 1 < depth.width; ++column) {
      const std::size_t at = depth.index(column, row);
      if (depth.z_m[at] > 0.0F) continue;
      const float left = depth.z_m[at - 1];
      const float right = depth.z_m[at + 1];
      const float above = depth.z_m[at - width];
      const float below = depth.z_m[at + width];
      const float least = std::min({left, right, above, below});
      if (least <= 0.0F || std::max({left, right, above, below}) - least > break_at(least, limit)) continue;
      depth.z_m[at] = 4.0F / (1.0F / left + 1.0F / right + 1.0F / above + 1.0F / below);
    }
}

}  // namespace telepalp::surface
