#include "haptic_station/surface/motion_field.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

// A critically damped g-h filter (Brookner 1998, §1.2.6) that remembers about 1/(1 - theta) frames: velocity errs by
// acceleration x 0.15 s, noise of a cell's mean is reduced to a tenth of a millimetre a second.
constexpr double kTheta = 0.75;
constexpr double kPositionGain = 1.0 - kTheta * kTheta;
constexpr double kVelocityGain = (1.0 - kTheta) * (1.0 - kTheta);
constexpr double kBreathMemory_s = 10.0;
constexpr double kEnergyMemory_s = 4.0;
constexpr double kLeastCount = 12.0;  // pixels, before a cell's mean says anything
constexpr double kVelocityFade_s = 1.0;

}  // namespace

MotionField::MotionField(int width_px, int height_px, bool breathing)
    : columns_((width_px + kCell_px - 1) / kCell_px),
      rows_((height_px + kCell_px - 1) / kCell_px),
      breathing_wanted_(breathing),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      change_(cells_.size(), 0.0F),
      correction_(cells_.size(), 0.0F) {
  forget_breath();
}

void MotionField::forget_breath() noexcept {
  breath_covariance_ = BreathTerms::Constant(1e4).asDiagonal();
  for (Cell& cell : cells_) cell.breath.setZero();
}

const std::vector<float>& MotionField::predict(double dt_s) {
  const double believed = breathing_wanted_ ? breathing_.confidence() : 0.0;
  MotionModel ahead = model();
  ahead.linear_fade_s = kVelocityFade_s;
  const MotionBasis basis = motion_basis(ahead, dt_s);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    const MotionTerms terms = terms_of(cell);
    double change = 0.0;
    double breath_rate = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k) change += static_cast<double>(terms[k] * basis.value[k]);
    for (std::size_t k = 1; k < terms.size(); ++k) breath_rate += static_cast<double>(terms[k] * basis.rate[k]);
    cell.velocity_m_per_s = breath_rate + (1.0 - believed) * cell.velocity_m_per_s;
    cell.displacement_m += change;
    change_[i] = static_cast<float>(change);
  }
  return change_;
}

const std::vector<float>& MotionField::correct(const std::vector<CellInnovation>& seen, double dt_s) {
  frame_s_ = dt_s;
  double moved = 0.0;
  double moving = 1e-18;
  double missed = 0.0;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const auto at = static_cast<std::size_t>(row * columns_ + column);
      double sum = 0.0;
      double count = 0.0;
      for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
          const CellInnovation& near = seen[static_cast<std::size_t>(r * columns_ + c)];
          const double weight = near.count * (r == row && c == column ? 4.0 : (r == row || c == column ? 2.0 : 1.0));
          sum += weight * near.mean_m;
          count += weight;
        }
      Cell& cell = cells_[at];
      if (seen[at].count < kLeastCount) {
        cell.frames = 0.0;
        cell.velocity_m_per_s = 0.0;
        correction_[at] = 0.0F;
        continue;
      }
      const double innovation = sum / count;
      // A young cell takes what it sees at once; the gains settle as it ages.
      cell.frames += 1.0;
      const double position_gain = std::max(kPositionGain, 1.0 / cell.frames);
      const double velocity_gain = cell.frames < 3.0 ? 0.0 : kVelocityGain;
      cell.displacement_m += position_gain * innovation;
      cell.velocity_m_per_s += velocity_gain * innovation / dt_s;
      correction_[at] = static_cast<float>(position_gain * innovation);
      const double change = static_cast<double>(change_[at]) + position_gain * innovation;
      cell.energy += dt_s / kEnergyMemory_s * (cell.velocity_m_per_s * cell.velocity_m_per_s - cell.energy);
      const double weight = cell.energy * cell.energy;  // squared: noise must not outvote a small moving part
      moved += weight * change;
      moving += weight;
      missed += weight * std::abs(innovation);
    }
  mean_displacement_m_ += moved / moving;
  miss_m_ += 0.1 * (missed / moving - miss_m_);
  if (breathing_wanted_) learn_breath(dt_s);
  return correction_;
}

/// Recursive least squares with forgetting; the regressors are common, so the gain is worked out once for all cells.
void MotionField::learn_breath(double dt_s) {
  const double before = breathing_.confidence();
  breathing_.add(mean_displacement_m_, dt_s);
  if (breathing_.confidence() <= 0.0) {
    if (before > 0.0) forget_breath();
    return;
  }
  const double keep = std::exp(-dt_s / kBreathMemory_s);
  const BreathTerms terms = breathing_.terms();
  const BreathTerms reach = breath_covariance_ * terms;
  const BreathTerms gain = reach / (keep + terms.dot(reach));
  breath_covariance_ = ((breath_covariance_ - gain * reach.transpose()) / keep).eval();
  for (Cell& cell : cells_) cell.breath += gain * (cell.displacement_m - terms.dot(cell.breath));
}

/// Turns a cell's breath to the phase of the last frame: A (cos ωτ − 1) + B sin ωτ and the same of the second harmonic.
MotionTerms MotionField::terms_of(const Cell& cell) const noexcept {
  const double believed = breathing_wanted_ ? breathing_.confidence() : 0.0;
  const BreathTerms at = breathing_.terms();
  const BreathTerms& b = cell.breath;
  return {static_cast<float>((1.0 - believed) * cell.velocity_m_per_s),
          static_cast<float>(believed * (b[1] * at[1] + b[2] * at[2])),
          static_cast<float>(believed * (b[2] * at[1] - b[1] * at[2])),
          static_cast<float>(believed * (b[3] * at[3] + b[4] * at[4])),
          static_cast<float>(believed * (b[4] * at[3] - b[3] * at[4]))};
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
    const MotionTerms terms = terms_of(cells_[static_cast<std::size_t>(row * columns_ + column)]);
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
  model.breathing_rad_per_s = breathing_.rad_per_s();
  model.linear_fade_s = kVelocityFade_s;
  model.spread_m_per_s = miss_m_ * kVelocityGain / frame_s_ * 4.0;
  return model;
}

}  // namespace telepalp::surface
