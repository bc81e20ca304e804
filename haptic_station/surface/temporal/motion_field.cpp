#include "haptic_station/surface/temporal/motion_field.h"

#include <algorithm>
#include <cmath>

#include "haptic_station/surface/temporal/hidden_cells.h"

namespace telepalp::surface {
namespace {

constexpr double kEnergyMemory_s = 4.0;
constexpr double kVelocityFade_s = 1.0;
constexpr double kSharedMotion_rad_per_s = 3.0;  // while no breath is known: predicted motion reverses after 0.5 s

}  // namespace

MotionField::MotionField(int width_px, int height_px, const SurfaceSettings& settings)
    : lattice_(lattice_of(width_px, height_px)),
      breathing_wanted_(settings.breathing),
      shared_wanted_(settings.shared),
      velocity_m_per_s_(lattice_.size(), 0.0),
      energy_(lattice_.size(), 0.0),
      means_(lattice_.size()),
      gains_(lattice_),
      displacement_(lattice_.size(), 0.0F),
      observed_(lattice_.size(), 0.0F),
      weight_(lattice_.size(), 0.0F),
      change_(lattice_.size(), 0.0F),
      moved_(lattice_.size(), 0.0F),
      expected_(lattice_.size(), 0.0F),
      terms_(lattice_.size()),
      shared_(lattice_.size()),
      shared_seen_(lattice_.size()),
      straight_(lattice_),
      mean_(lattice_.size()),
      counts_(lattice_.size(), 0.0F) {}

/// Predicts the motion from terms_, which include the breathing model. The shared motion is set to this prediction,
/// because the innovations of the next frame are relative to it.
void MotionField::predict(double dt_s) {
  if (shared_wanted_) straight_.predict(dt_s);
  MotionModel ahead = unbounded_model();
  ahead.speed = ahead.acceleration = kFullForesight;
  ahead.linear_fade_s = 1e3;  // between frames the velocity is constant; only predictions decay
  const MotionBasis basis = motion_basis(ahead, dt_s);
  const double w2 = rate_rad_per_s() * rate_rad_per_s();
  std::vector<SharedPrediction> shared(lattice_.size());
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    const MotionTerms& terms = terms_[i];
    float change = 0.0F;
    float rate = 0.0F;
    for (std::size_t k = 0; k < basis.value.size(); ++k) {
      change += terms[k] * basis.value[k];
      rate += terms[k] * basis.rate[k];
    }
    velocity_m_per_s_[i] = static_cast<double>(rate);
    displacement_[i] += change;
    change_[i] = change;
    const double swing = static_cast<double>(terms[1] * (basis.value[1] + 1.0F) + terms[2] * basis.value[2]);
    const double second = static_cast<double>(terms[3] * (basis.value[3] + 1.0F) + terms[4] * basis.value[4]);
    shared[i] = {static_cast<double>(change - terms[0] * basis.value[0]),
                 static_cast<double>(rate - terms[0] * basis.rate[0]), -w2 * (swing + 4.0 * second)};
  }
  shared_.predict(shared, dt_s, rate_rad_per_s());
  for (std::size_t i = 0; i < lattice_.size(); ++i) velocity_m_per_s_[i] -= shared_.share(i) * shared_.speed_m_per_s();
}

/// The cells' own filters get the innovations that the shared motion does not explain.
void MotionField::update_gains(const std::vector<CellInnovation>& seen) {
  std::vector<CellMean> wide = wide_means(lattice_, means_);
  for (std::size_t at = 0; at < lattice_.size(); ++at) wide[at].mean -= shared_.share(at) * shared_.innovation_m();
  gains_.add(seen, wide);
}

void MotionField::correct_cell(std::size_t at, double innovation_m, double dt_s) noexcept {
  const double shared_m = shared_.share(at) * shared_.innovation_m();
  const double own_m = innovation_m - shared_m;
  const auto correction = static_cast<float>(gains_.position(at) * own_m + shared_.share(at) * shared_.corrected_m());
  displacement_[at] += correction;
  moved_[at] = change_[at] + correction;
  expected_[at] = change_[at] + static_cast<float>(innovation_m);
  velocity_m_per_s_[at] += gains_.velocity(at) * own_m / dt_s;
  const double speed_m_per_s = velocity_m_per_s_[at] + shared_.share(at) * shared_.speed_m_per_s();
  const double speed2 = speed_m_per_s * speed_m_per_s;
  energy_[at] += dt_s / kEnergyMemory_s * (speed2 - energy_[at]);
}

/// The measured displacement, smoothed. The sum of coefficients and smoothed innovation is not used: smoothing removes
/// a part of the innovation, that part would come from the breathing model alone, and the model would be fitted to its
/// own output.
void MotionField::update_observed() {
  const std::vector<float> modelled = means_of(lattice_, displacement_);
  for (std::size_t at = 0; at < means_.size(); ++at) means_[at].mean += static_cast<double>(modelled[at]);
  observed_ = smooth_coefficients(lattice_, means_);
}

/// The shared motion explains its part of the innovations; the cells' own filters get the rest.
void MotionField::correct_shared(const std::vector<CellInnovation>& seen, const std::vector<float>& innovation,
                                 double dt_s) {
  if (!shared_wanted_) return;
  for (std::size_t at = 0; at < seen.size(); ++at)
    shared_seen_[at] = {static_cast<double>(innovation[at]), seen[at].count < kLeastCount ? 0.0 : seen[at].sigma_m};
  shared_.correct(shared_seen_, dt_s);
}

void MotionField::take_means(const std::vector<CellInnovation>& seen) {
  std::transform(seen.begin(), seen.end(), means_.begin(), [](const CellInnovation& cell) {
    return CellMean{cell.mean_m, cell.count};
  });
}

std::vector<CellInnovation> MotionField::filled(const std::vector<CellInnovation>& seen,
                                                std::span<const std::uint8_t> hidden) const {
  std::vector<double> shared_m(seen.size());
  for (std::size_t at = 0; at < seen.size(); ++at) shared_m[at] = shared_.share(at) * shared_.innovation_m();
  std::vector<CellInnovation> all = seen;
  fill_hidden(lattice_, hidden, shared_m, all);
  return all;
}

void MotionField::correct(const std::vector<CellInnovation>& seen, double dt_s, std::span<const std::uint8_t> hidden) {
  frame_s_ = dt_s;
  take_means(seen);
  std::vector<float> innovation = smooth_coefficients(lattice_, means_);
  correct_shared(seen, innovation, dt_s);
  const std::vector<CellInnovation> moved = hidden.empty() ? seen : filled(seen, hidden);
  if (!hidden.empty()) {
    take_means(moved);
    innovation = smooth_coefficients(lattice_, means_);
  }
  if (shared_wanted_) straight_.correct(moved, displacement_, dt_s);
  update_gains(moved);
  update_observed();
  if (shared_wanted_) judge_predictions(seen, dt_s);
  double moving = 1e-18;
  double missed = 0.0;
  for (std::size_t at = 0; at < lattice_.size(); ++at) {
    const auto innovation_m = static_cast<double>(innovation[at]);
    correct_cell(at, innovation_m, dt_s);
    const double energy = seen[at].count < kLeastCount ? 0.0 : energy_[at];
    weight_[at] = static_cast<float>(1e12 * energy * energy);  // squared, so that noise does not outweigh the belly
    moving += static_cast<double>(weight_[at]);
    missed += static_cast<double>(weight_[at]) * std::abs(innovation_m);
  }
  if (shared_wanted_) shared_.learn(observed_, dt_s);
  smooth_velocities(lattice_, velocity_m_per_s_);
  miss_m_ += 0.1 * (missed / moving - miss_m_);
  if (breathing_wanted_) breathing_.add(observed_, weight_, dt_s);
  update_terms();
}

/// Learns from the frame how right the predictions were, before it changes what they predict next.
void MotionField::judge_predictions(const std::vector<CellInnovation>& seen, double dt_s) {
  std::transform(seen.begin(), seen.end(), counts_.begin(),
                 [](const CellInnovation& cell) { return cell.count < kLeastCount ? 0.0F : 1.0F; });
  straight_.measure(observed_, dt_s);
  past_.judge(observed_, counts_, dt_s);
  way_.add(observed_, counts_, dt_s);
  mean_.add(observed_, dt_s);
}

void MotionField::update_terms() {
  const double breath = believed();
  const double w = rate_rad_per_s();
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    MotionTerms terms = breath > 0.0 ? breathing_.motion_of(i) : MotionTerms{};
    for (float& term : terms) term *= static_cast<float>(breath);
    const double share = (1.0 - breath) * shared_.share(i);
    terms[0] = static_cast<float>((1.0 - breath) * velocity_m_per_s_[i]);
    terms[1] -= static_cast<float>(share * shared_.acceleration_m_per_s2() / (w * w));
    terms[2] += static_cast<float>(share * shared_.speed_m_per_s() / w);
    if (shared_wanted_) {
      terms[kStraightTerm] = static_cast<float>(straight_.velocity_m_per_s(i));
      terms[kMeanTerm] = static_cast<float>(mean_.m(i)) - displacement_[i];
    }
    terms_[i] = terms;
  }
  if (shared_wanted_) past_.remember(displacement_, terms_, model_of_each());
}

double MotionField::rate_rad_per_s() const noexcept {
  return believed() > 0.0 ? breathing_.rad_per_s() : kSharedMotion_rad_per_s;
}

/// The speed of the faster one of the two predictions that move: the root mean square over the measured cells.
double MotionField::fastest_m_per_s() const noexcept {
  MotionModel model = unbounded_model();
  model.own = model.straight = kFullForesight;
  const MotionBasis basis = motion_basis(model, 0.0);
  double own = 0.0;
  double straight = 0.0;
  double sum = 1e-30;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    double rate = 0.0;
    for (std::size_t k = 0; k < kStraightTerm; ++k) rate += static_cast<double>(terms_[i][k] * basis.rate[k]);
    const auto counts = static_cast<double>(counts_[i]);
    own += counts * rate * rate;
    straight += counts * static_cast<double>(terms_[i][kStraightTerm] * terms_[i][kStraightTerm]);
    sum += counts;
  }
  return std::sqrt(std::max(own, straight) / sum);
}

/// The model with the bound of the way, before the predictions are weighted.
MotionModel MotionField::model_of_each() const noexcept {
  MotionModel model = unbounded_model();
  if (!shared_wanted_) return model;
  const double within_s = freeze_within(way_.m(), fastest_m_per_s(), model.freeze_from_s);
  model.freeze_from_s += model.unmodelled * (within_s - model.freeze_from_s);
  return model;
}

MotionModel MotionField::model() const noexcept {
  MotionModel model = model_of_each();
  if (!shared_wanted_) return model;
  model.own = past_.own();
  model.straight = past_.straight();
  model.to_mean = past_.to_mean();
  return model;
}

MotionModel MotionField::unbounded_model() const noexcept {
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
