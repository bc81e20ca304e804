#include "haptic_station/surface/temporal/motion_field.h"

#include <algorithm>
#include <cmath>

namespace telepalp::surface {
namespace {

// A critically damped g-h filter (Brookner 1998, 1.2.6) remembers about 1/(1 - theta) frames. The memory is short where
// the innovations have a consistent sign, because the motion changes there. It is long where they are only noise,
// because a cell's noise moves all its pixels together, and the average of the pixels cannot remove it.
constexpr double kQuickTheta = 0.60;
constexpr double kCalmTheta = 0.90;
constexpr double kLeanGain = 0.3;
constexpr double kCalmUpTo = 2.5;  // below this mean innovation [sigma] a cell counts as calm
constexpr double kQuickFrom = 6.5;
constexpr double kEnergyMemory_s = 4.0;
constexpr double kLeastCount = 12.0;  // least number of pixels for a cell's mean to be used
constexpr double kVelocityFade_s = 1.0;
constexpr double kSharedMotion_rad_per_s = 3.0;  // while no breath is known: predicted motion reverses after 0.5 s
constexpr double kRoughnessLeak = 0.1;           // share of the velocities' roughness removed per frame

/// How significant a running mean of innovations is: 0 within the noise, 1 certain.
double leaning(double lean_m, double sigma_m) noexcept {
  const double chance_m = sigma_m * std::sqrt(kLeanGain / (2.0 - kLeanGain)) + 1e-6;
  return std::clamp((std::abs(lean_m) / chance_m - kCalmUpTo) / (kQuickFrom - kCalmUpTo), 0.0, 1.0);
}

}  // namespace

MotionField::MotionField(int width_px, int height_px, const SurfaceSettings& settings)
    : lattice_(lattice_of(width_px, height_px)),
      breathing_wanted_(settings.breathing),
      shared_wanted_(settings.shared),
      cells_(lattice_.size()),
      means_(lattice_.size()),
      moving_(lattice_.size()),
      displacement_(lattice_.size(), 0.0F),
      observed_(lattice_.size(), 0.0F),
      weight_(lattice_.size(), 0.0F),
      change_(lattice_.size(), 0.0F),
      moved_(lattice_.size(), 0.0F),
      expected_(lattice_.size(), 0.0F),
      terms_(lattice_.size()),
      shared_(lattice_.size()),
      shared_seen_(lattice_.size()) {}

/// Predicts the motion from terms_, which include the breathing model. The shared motion is set to this prediction,
/// because the innovations of the next frame are relative to it.
void MotionField::predict(double dt_s) {
  MotionModel ahead = model();
  ahead.speed = ahead.acceleration = kFullForesight;
  ahead.linear_fade_s = 1e3;  // between frames the velocity is constant; only predictions decay
  const MotionBasis basis = motion_basis(ahead, dt_s);
  const double w2 = rate_rad_per_s() * rate_rad_per_s();
  std::vector<SharedPrediction> shared(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const MotionTerms& terms = terms_[i];
    float change = 0.0F;
    float rate = 0.0F;
    for (std::size_t k = 0; k < basis.value.size(); ++k) {
      change += terms[k] * basis.value[k];
      rate += terms[k] * basis.rate[k];
    }
    cells_[i].velocity_m_per_s = static_cast<double>(rate);
    displacement_[i] += change;
    change_[i] = change;
    const double swing = static_cast<double>(terms[1] * (basis.value[1] + 1.0F) + terms[2] * basis.value[2]);
    const double second = static_cast<double>(terms[3] * (basis.value[3] + 1.0F) + terms[4] * basis.value[4]);
    shared[i] = {static_cast<double>(change - terms[0] * basis.value[0]),
                 static_cast<double>(rate - terms[0] * basis.rate[0]), -w2 * (swing + 4.0 * second)};
  }
  shared_.predict(shared, dt_s, rate_rad_per_s());
  for (std::size_t i = 0; i < cells_.size(); ++i)
    cells_[i].velocity_m_per_s -= shared_.share(i) * shared_.speed_m_per_s();
}

/// Finds where the innovations have a consistent sign. It uses neighbourhoods, because a body moves as a whole and
/// noise does not, and because gains that change from cell to cell would make a smooth motion rough.
void MotionField::update_moving(const std::vector<CellInnovation>& seen) {
  const std::vector<CellMean> wide = wide_means(lattice_, means_);
  for (std::size_t at = 0; at < cells_.size(); ++at) {
    const double narrower = std::sqrt(seen[at].count / std::max(wide[at].count, 1.0));
    double& lean_m = cells_[at].lean_m;
    lean_m += kLeanGain * (wide[at].mean - shared_.share(at) * shared_.innovation_m() - lean_m);
    moving_[at] = {leaning(lean_m, narrower * seen[at].sigma_m), seen[at].count};
  }
  moving_ = wide_means(lattice_, moving_);
}

/// The gains of a cell are large in its first frames and settle later.
void MotionField::correct_cell(std::size_t at, double innovation_m, double dt_s) noexcept {
  Cell& cell = cells_[at];
  cell.frames += 1.0;
  const double shared_m = shared_.share(at) * shared_.innovation_m();
  const double own_m = innovation_m - shared_m;
  const double theta = kCalmTheta + moving_[at].mean * (kQuickTheta - kCalmTheta);
  const double position_gain = std::max(1.0 - theta * theta, 1.0 / cell.frames);
  const double velocity_gain = cell.frames < 3.0 ? 0.0 : (1.0 - theta) * (1.0 - theta);
  const auto correction = static_cast<float>(position_gain * own_m + shared_.share(at) * shared_.corrected_m());
  displacement_[at] += correction;
  moved_[at] = change_[at] + correction;
  expected_[at] = change_[at] + static_cast<float>(innovation_m);
  cell.velocity_m_per_s += velocity_gain * own_m / dt_s;
  const double speed_m_per_s = cell.velocity_m_per_s + shared_.share(at) * shared_.speed_m_per_s();
  const double speed2 = speed_m_per_s * speed_m_per_s;
  cell.energy += dt_s / kEnergyMemory_s * (speed2 - cell.energy);
}

/// The measured displacement, smoothed. The sum of coefficients and smoothed innovation is not used: smoothing removes
/// a part of the innovation, that part would come from the breathing model alone, and the model would be fitted to its
/// own output.
void MotionField::update_observed() {
  const std::vector<float> modelled = means_of(lattice_, displacement_);
  for (std::size_t at = 0; at < means_.size(); ++at) means_[at].mean += static_cast<double>(modelled[at]);
  observed_ = smooth_coefficients(lattice_, means_);
}

/// The filter cannot see the part of the innovations that smoothing removes, so the velocities are smoothed alike.
void MotionField::smooth_velocities() {
  std::vector<float> velocity(cells_.size());
  std::transform(cells_.begin(), cells_.end(), velocity.begin(),
                 [](const Cell& cell) { return static_cast<float>(cell.velocity_m_per_s); });
  const std::vector<float> means = means_of(lattice_, velocity);
  std::vector<CellMean> whole(means.size());
  std::transform(means.begin(), means.end(), whole.begin(), [](float mean) {
    return CellMean{static_cast<double>(mean), CellLattice::kCell_px * CellLattice::kCell_px};
  });
  const std::vector<float> smooth = smooth_coefficients(lattice_, whole);
  for (std::size_t at = 0; at < cells_.size(); ++at)
    cells_[at].velocity_m_per_s += kRoughnessLeak * (static_cast<double>(smooth[at]) - cells_[at].velocity_m_per_s);
}

/// The shared motion explains its part of the innovations; the cells' own filters get the rest.
void MotionField::correct_shared(const std::vector<CellInnovation>& seen, const std::vector<float>& innovation,
                                 double dt_s) {
  if (!shared_wanted_) return;
  for (std::size_t at = 0; at < seen.size(); ++at)
    shared_seen_[at] = {static_cast<double>(innovation[at]), seen[at].count < kLeastCount ? 0.0 : seen[at].sigma_m};
  shared_.correct(shared_seen_, dt_s);
}

void MotionField::correct(const std::vector<CellInnovation>& seen, double dt_s) {
  frame_s_ = dt_s;
  std::transform(seen.begin(), seen.end(), means_.begin(), [](const CellInnovation& cell) {
    return CellMean{cell.mean_m, cell.count};
  });
  const std::vector<float> innovation = smooth_coefficients(lattice_, means_);
  correct_shared(seen, innovation, dt_s);
  update_moving(seen);
  update_observed();
  double moving = 1e-18;
  double missed = 0.0;
  for (std::size_t at = 0; at < cells_.size(); ++at) {
    const auto innovation_m = static_cast<double>(innovation[at]);
    correct_cell(at, innovation_m, dt_s);
    const double energy = seen[at].count < kLeastCount ? 0.0 : cells_[at].energy;
    weight_[at] = static_cast<float>(1e12 * energy * energy);  // squared, so that noise does not outweigh the belly
    moving += static_cast<double>(weight_[at]);
    missed += static_cast<double>(weight_[at]) * std::abs(innovation_m);
  }
  if (shared_wanted_) shared_.learn(observed_, dt_s);
  smooth_velocities();
  miss_m_ += 0.1 * (missed / moving - miss_m_);
  if (breathing_wanted_) breathing_.add(observed_, weight_, dt_s);
  update_terms();
}

void MotionField::update_terms() {
  const double breath = believed();
  const double w = rate_rad_per_s();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    MotionTerms terms = breath > 0.0 ? breathing_.motion_of(i) : MotionTerms{};
    for (float& term : terms) term *= static_cast<float>(breath);
    const double share = (1.0 - breath) * shared_.share(i);
    terms[0] = static_cast<float>((1.0 - breath) * cells_[i].velocity_m_per_s);
    terms[1] -= static_cast<float>(share * shared_.acceleration_m_per_s2() / (w * w));
    terms[2] += static_cast<float>(share * shared_.speed_m_per_s() / w);
    terms_[i] = terms;
  }
}

double MotionField::rate_rad_per_s() const noexcept {
  return believed() > 0.0 ? breathing_.rad_per_s() : kSharedMotion_rad_per_s;
}

MotionModel MotionField::model() const noexcept {
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = rate_rad_per_s();
  const auto blended = [breath = believed()](ForesightShare share) {
    for (double& one : share) one = breath + (1.0 - breath) * one;
    return share;
  };
  model.speed = blended(shared_.speed_share());
  model.acceleration = blended(shared_.acceleration_share());
  model.linear_fade_s = kVelocityFade_s;
  model.spread_m_per_s = 0.5 * miss_m_ / frame_s_;
  model.unmodelled = shared_.unmodelled();
  return model;
}

}  // namespace telepalp::surface
