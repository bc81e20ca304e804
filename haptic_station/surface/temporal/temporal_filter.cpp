#include "haptic_station/surface/temporal/temporal_filter.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/temporal/filter_rows.h"

namespace telepalp::surface {
namespace {

constexpr int kCellSide = CellLattice::kCell_px;
constexpr float kPatchOutlier = 4.5F;
constexpr float kStartAnew_frames = 4.0F;
constexpr double kNoiseGain = 0.05;
constexpr double kMeanSizeOfUnit = 1.2533;  // ratio of sigma to the mean absolute value of a Gaussian

}  // namespace

TemporalFilter::TemporalFilter(int width, int height, const SurfaceSettings& settings)
    : motion_(width, height, settings), memory_frames_(static_cast<float>(std::max(1.0, settings.memory_frames))) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  average_ = {.width = width,
              .height = height,
              .z_m = std::vector<float>(count, 0.0F),
              .weight = std::vector<float>(count, 0.0F)};
  moved_at_.resize(row_length(motion_.lattice()));
  expected_at_.resize(row_length(motion_.lattice()));
  sums_.resize(4 * static_cast<std::size_t>(width));
  seen_.resize(motion_.lattice().size());
  patch_mean_.assign(static_cast<std::size_t>((width + kPatch_px - 1) / kPatch_px) *
                         static_cast<std::size_t>((height + kPatch_px - 1) / kPatch_px),
                     0.0F);
}

const DepthField& TemporalFilter::add(const DepthField& seen, double dt_s, std::span<const std::uint8_t> hidden) {
  if (first_) {
    first_ = false;
    average_.z_m = seen.z_m;
    std::transform(seen.z_m.begin(), seen.z_m.end(), average_.weight.begin(),
                   [](float z) { return z > 0.0F ? 1.0F : 0.0F; });
    return average_;
  }
  motion_.predict(dt_s);
  observe(seen);
  find_hidden_cells(hidden);
  motion_.correct(seen_, dt_s, hidden_cells_);
  keep_hidden(hidden);
  update(seen);
  return average_;
}

void TemporalFilter::find_hidden_cells(std::span<const std::uint8_t> hidden) {
  hidden_cells_.clear();
  if (hidden.empty()) return;
  const BlockLattice blocks = blocks_of(average_.width, average_.height);
  constexpr int kAcross = kCellSide / kPatch_px;
  constexpr double kSeen_px = 0.25 * kCellSide * kCellSide;  // with so many pixels, a cell's own innovation counts
  std::vector<int> count(seen_.size(), 0);
  for (int row = 0; row < blocks.rows; ++row)
    for (int column = 0; column < blocks.columns; ++column)
      count[motion_.lattice().at(column / kAcross, row / kAcross)] += hidden[blocks.at(column, row)] != 0 ? 1 : 0;
  hidden_cells_.resize(seen_.size());
  for (std::size_t at = 0; at < seen_.size(); ++at)
    hidden_cells_[at] = 2 * count[at] >= kAcross * kAcross && seen_[at].count < kSeen_px ? 1 : 0;
}

/// update() takes a part of the frame count from a pixel that is not measured. The pixels of hidden blocks get it back.
void TemporalFilter::keep_hidden(std::span<const std::uint8_t> hidden) {
  if (hidden.empty()) return;
  const BlockLattice blocks = blocks_of(average_.width, average_.height);
  for (int v = 0; v < average_.height; ++v)
    for (int u = 0; u < average_.width; ++u)
      if (hidden[blocks.at(u / kPatch_px, v / kPatch_px)] != 0) average_.weight[average_.index(u, v)] /= kUnseenKeep;
}

/// Mean innovation of each cell.
void TemporalFilter::observe(const DepthField& seen) {
  const auto width = static_cast<std::size_t>(seen.width);
  const ColumnSums sums{sums_.data(), &sums_[width], &sums_[2 * width], &sums_[3 * width]};
  noise_sum_ = noise_count_ = 0.0;
  for (int row = 0; row < seen.height; ++row) {
    if (row % kCellSide == 0) std::fill(sums_.begin(), sums_.end(), 0.0F);
    spread_over_row(motion_.lattice(), motion_.change(), row, moved_at_);
    const std::size_t start = seen.index(0, row);
    observe_row(&seen.z_m[start], &average_.z_m[start], &moved_at_[kRowLead], seen.width, {noise_scale_}, sums);
    if (row % kCellSide == kCellSide - 1 || row + 1 == seen.height) end_of_cells(row / kCellSide);
  }
  if (noise_count_ > 100.0)
    noise_scale_ += static_cast<float>(
        kNoiseGain * (kMeanSizeOfUnit * noise_sum_ / noise_count_ - static_cast<double>(noise_scale_)));
}

/// Turns the sums by column into the means of a row of cells.
void TemporalFilter::end_of_cells(int cell_row) {
  const auto width = static_cast<std::size_t>(average_.width);
  for (int column = 0; column < motion_.lattice().columns; ++column) {
    const auto from = static_cast<std::size_t>(column * kCellSide);
    const std::size_t to = std::min(width, from + kCellSide);
    CellInnovation cell;
    double unit = 0.0;
    for (std::size_t u = from; u < to; ++u) {
      cell.mean_m += static_cast<double>(sums_[u]);
      unit += static_cast<double>(sums_[width + u]);
      cell.sigma_m += static_cast<double>(sums_[2 * width + u]);
      cell.count += static_cast<double>(sums_[3 * width + u]);
    }
    noise_sum_ += unit;
    noise_count_ += cell.count;
    const double count = std::max(cell.count, 1.0);
    cell.mean_m /= count;
    cell.sigma_m /= count * std::sqrt(count);  // mean sigma / square root of the count
    seen_[motion_.lattice().at(column, cell_row)] = cell;
  }
}

void TemporalFilter::update(const DepthField& seen) {
  const auto width = static_cast<std::size_t>(seen.width);
  const LeanSums leans{sums_.data(), &sums_[width]};
  for (int row = 0; row < seen.height; ++row) {
    if (row % kPatch_px == 0) std::fill_n(sums_.begin(), 2 * width, 0.0F);
    spread_over_row(motion_.lattice(), motion_.moved(), row, moved_at_);
    spread_over_row(motion_.lattice(), motion_.expected(), row, expected_at_);
    const std::size_t start = seen.index(0, row);
    update_row(&seen.z_m[start], &moved_at_[kRowLead], &expected_at_[kRowLead], seen.width, {noise_scale_},
               memory_frames_, {&average_.z_m[start], &average_.weight[start]}, leans);
    if (row % kPatch_px == kPatch_px - 1 || row + 1 == seen.height) end_of_patches(row / kPatch_px);
  }
}

/// A patch whose residuals have a consistent sign moves in a way that no cell follows. The averages of its pixels start
/// anew.
void TemporalFilter::end_of_patches(int patch_row) {
  const auto width = static_cast<std::size_t>(average_.width);
  const std::size_t across = (width + kPatch_px - 1) / kPatch_px;
  for (std::size_t patch = 0; patch < across; ++patch) {
    const std::size_t from = patch * kPatch_px;
    const std::size_t to = std::min(width, from + kPatch_px);
    float lean = 0.0F;
    float count = 0.0F;
    for (std::size_t u = from; u < to; ++u) {
      lean += sums_[u];
      count += sums_[width + u];
    }
    float& mean = patch_mean_[static_cast<std::size_t>(patch_row) * across + patch];
    mean = 0.5F * (mean + (count > 0.0F ? lean / std::sqrt(count) : 0.0F));  // unit variance under noise alone
    if (std::abs(mean) < kPatchOutlier * 0.577F)
      continue;  // sqrt(1/3): standard deviation of a running mean with weight 1/2
    for (int row = patch_row * kPatch_px; row < std::min((patch_row + 1) * kPatch_px, average_.height); ++row)
      for (std::size_t u = from; u < to; ++u) {
        float& frames = average_.weight[average_.index(0, row) + u];
        frames = std::min(frames, kStartAnew_frames);
      }
  }
}

namespace {

constexpr int kRun_px = 16;

bool all_measured(const float* z_m) noexcept {
  int measured = 0;
  for (int u = 0; u < kRun_px; ++u) measured += z_m[u] > 0.0F ? 1 : 0;
  return measured == kRun_px;
}

void fill_pinhole(DepthField& depth, std::size_t at, float break_at_1m) {
  if (depth.z_m[at] > 0.0F) return;
  const auto width = static_cast<std::size_t>(depth.width);
  const float left = depth.z_m[at - 1];
  const float right = depth.z_m[at + 1];
  const float above = depth.z_m[at - width];
  const float below = depth.z_m[at + width];
  const float least = std::min({left, right, above, below});
  if (least <= 0.0F || std::max({left, right, above, below}) - least > break_at(least, break_at_1m)) return;
  depth.z_m[at] = 4.0F / (1.0F / left + 1.0F / right + 1.0F / above + 1.0F / below);
}

}  // namespace

void fill_pinholes(DepthField& depth, double break_at_1m) {
  const auto limit = static_cast<float>(break_at_1m);
  for (int row = 1; row + 1 < depth.height; ++row)
    for (int column = 1; column + 1 < depth.width; column += kRun_px) {
      const int end = std::min(column + kRun_px, depth.width - 1);
      if (end - column == kRun_px && all_measured(&depth.z_m[depth.index(column, row)])) continue;
      for (int u = column; u < end; ++u) fill_pinhole(depth, depth.index(u, row), limit);
    }
}

}  // namespace telepalp::surface
