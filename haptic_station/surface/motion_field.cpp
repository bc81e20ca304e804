#include "haptic_station/surface/motion_field.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

// A critically damped g-h filter (Brookner 1998, 1.2.6) remembers about 1/(1 - theta) frames. Short memory where the
// innovations lean to one side, since there the motion changes; long where they are chance, since a cell's noise would
// move all its pixels together and no average of theirs would take it out.
constexpr double kQuickTheta = 0.60;
constexpr double kCalmTheta = 0.93;
constexpr double kLeanGain = 0.3;
constexpr double kCalmUpTo = 2.0;  // sigmas of the lean
constexpr double kQuickFrom = 4.5;
constexpr double kSmoothedSigma = 0.375;  // of nine cells weighted 4 : 2 : 1, over one cell's
constexpr double kEnergyMemory_s = 4.0;
constexpr double kLeastCount = 12.0;  // pixels, before a cell's mean says anything
constexpr double kVelocityFade_s = 1.0;

}  // namespace

MotionField::MotionField(int width_px, int height_px, bool breathing)
    : columns_((width_px + kCell_px - 1) / kCell_px),
      rows_((height_px + kCell_px - 1) / kCell_px),
      breathing_wanted_(breathing),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      displacement_(cells_.size(), 0.0F),
      observed_(cells_.size(), 0.0F),
      weight_(cells_.size(), 0.0F),
      change_(cells_.size(), 0.0F),
      correction_(cells_.size(), 0.0F),
      innovation_(cells_.size(), 0.0F),
      terms_(cells_.size()) {}

const std::vector<float>& MotionField::predict(double dt_s) {
  MotionModel ahead = model();
  ahead.linear_fade_s = 1e3;  // between frames a velocity holds; it is beyond them that it is believed less and less
  const MotionBasis basis = motion_basis(ahead, dt_s);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    float change = 0.0F;
    float rate = 0.0F;
    for (std::size_t k = 0; k < basis.value.size(); ++k) {
      change += terms_[i][k] * basis.value[k];
      rate += terms_[i][k] * basis.rate[k];
    }
    cells_[i].velocity_m_per_s = static_cast<double>(rate);
    displacement_[i] += change;
    change_[i] = change;
  }
  return change_;
}

/// A cell's innovation with its neighbours', 4 : 2 : 1.
CellInnovation MotionField::smoothed(const std::vector<CellInnovation>& seen, int column, int row) const noexcept {
  CellInnovation sum;
  for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
    for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
      const CellInnovation& near = seen[static_cast<std::size_t>(r * columns_ + c)];
      const double weight = near.count * (r == row ? 2.0 : 1.0) * (c == column ? 2.0 : 1.0);
      sum.mean_m += weight * near.mean_m;
      sum.count += weight;
    }
  sum.mean_m /= std::max(sum.count, 1e-9);
  sum.sigma_m = kSmoothedSigma * seen[static_cast<std::size_t>(row * columns_ + column)].sigma_m;
  return sum;
}

/// A young cell takes what it sees at once; its gains settle as it ages.
void MotionField::correct_cell(std::size_t at, const CellInnovation& innovation, double dt_s) noexcept {
  Cell& cell = cells_[at];
  cell.frames += 1.0;
  cell.lean_m += kLeanGain * (innovation.mean_m - cell.lean_m);
  const double chance_m = innovation.sigma_m * std::sqrt(kLeanGain / (2.0 - kLeanGain)) + 1e-6;
  const double leaning = (std::abs(cell.lean_m) / chance_m - kCalmUpTo) / (kQuickFrom - kCalmUpTo);
  const double theta = kCalmTheta + std::clamp(leaning, 0.0, 1.0) * (kQuickTheta - kCalmTheta);
  const double position_gain = std::max(1.0 - theta * theta, 1.0 / cell.frames);
  const double velocity_gain = cell.frames < 3.0 ? 0.0 : (1.0 - theta) * (1.0 - theta);
  const auto correction = static_cast<float>(position_gain * innovation.mean_m);
  observed_[at] = displacement_[at] + static_cast<float>(innovation.mean_m);
  displacement_[at] += correction;
  correction_[at] = correction;
  innovation_[at] = static_cast<float>(innovation.mean_m);
  cell.velocity_m_per_s += velocity_gain * innovation.mean_m / dt_s;
  const double speed2 = cell.velocity_m_per_s * cell.velocity_m_per_s;
  cell.energy += dt_s / kEnergyMemory_s * (speed2 - cell.energy);
}

const std::vector<float>& MotionField::correct(const std::vector<CellInnovation>& seen, double dt_s) {
  frame_s_ = dt_s;
  double moving = 1e-18;
  double missed = 0.0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const auto at = static_cast<std::size_t>(row * columns_ + column);
      Cell& cell = cells_[at];
      if (seen[at].count < kLeastCount) {
        cell = {};
        correction_[at] = innovation_[at] = weight_[at] = 0.0F;
        continue;
      }
      const CellInnovation innovation = smoothed(seen, column, row);
      correct_cell(at, innovation, dt_s);
      weight_[at] = static_cast<float>(1e12 * cell.energy * cell.energy);  // squared: noise must not outvote the belly
      moving += static_cast<double>(weight_[at]);
      missed += static_cast<double>(weight_[at]) * std::abs(innovation.mean_m);
    }
  miss_m_ += 0.1 * (missed / moving - miss_m_);
  if (breathing_wanted_) breathing_.add(observed_, weight_, dt_s);
  update_terms();
  return correction_;
}

void MotionField::update_terms() {
  const double share = believed();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    MotionTerms terms{};
    if (share > 0.0) terms = breathing_.motion_of(i);
    for (float& term : terms) term *= static_cast<float>(share);
    terms[0] = static_cast<float>((1.0 - share) * cells_[i].velocity_m_per_s);
    terms_[i] = terms;
  }
}

MotionTerms MotionField::terms_at(double u, double v) const noexcept {
  const double x = std::clamp((u + 0.5) / kCell_px - 0.5, 0.0, static_cast<double>(columns_ - 1));
  const double y = std::clamp((v + 0.5) / kCell_px - 0.5, 0.0, static_cast<double>(rows_ - 1));
  const int left = std::min(static_cast<int>(x), std::max(0, columns_ - 2));
  const int top = std::min(static_cast<int>(y), std::max(0, rows_ - 2));
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - top);
  MotionTerms sum{};
  const auto add = [&](int column, int row, float weight) {
    if (weight <= 0.0F) return;
    const MotionTerms& terms = terms_[static_cast<std::size_t>(row * columns_ + column)];
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * terms[k];
  };
  add(left, top, (1.0F - fx) * (1.0F - fy));
  add(left + 1, top, fx * (1.0F - fy));
  add(left, top + 1, (1.0F - fx) * fy);
  add(left + 1, top + 1, fx * fy);
  return sum;
}

MotionModel MotionField::model() const noexcept {
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = believed() > 0.0 ? breathing_.rad_per_s() : 0.0;
  model.linear_fade_s = kVelocityFade_s;
  model.spread_m_per_s = 0.5 * miss_m_ / frame_s_;
  return model;
}

}  // namespace telepalp::surface
