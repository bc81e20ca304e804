#include <algorithm>
#include <cmath>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {
namespace {

/// A function of the age, and its derivative.
struct Progress {
  double s = 0.0;
  double rate = 0.0;
};

Progress product(const Progress& a, const Progress& b) noexcept { return {a.s * b.s, a.rate * b.s + a.s * b.rate}; }

/// The age that the motion model uses: equal to the true age at first, then slowing to a stop; C1. A surface that was
/// not measured for long must not be predicted farther, because nothing confirms the prediction.
Progress lived(double age_s, double freeze_from_s) noexcept {
  if (age_s < 0.0) return {};
  if (age_s <= freeze_from_s) return {age_s, 1.0};
  const double late = std::min(age_s - freeze_from_s, freeze_from_s);
  return {freeze_from_s + late - late * late / (2.0 * freeze_from_s), 1.0 - late / freeze_from_s};
}

/// Weight of a predicted motion at an age, and its derivative by age; both are continuous.
Progress believed(const ForesightShare& share, double age_s) noexcept {
  const bool late = age_s > kForesightAges_s[1];
  const double from_s = kForesightAges_s[late ? 1 : 0];
  const double span_s = kForesightAges_s[late ? 2 : 1] - from_s;
  const double change = share[late ? 2 : 1] - share[late ? 1 : 0];
  const double x = std::clamp((age_s - from_s) / span_s, 0.0, 1.0);
  return {share[late ? 1 : 0] + change * x * x * (3.0 - 2.0 * x), change * 6.0 * x * (1.0 - x) / span_s};
}

/// The way back to the mean place, from 0 at the capture to 1 at the first age for which a share is learned; C1.
Progress way_to_mean(double age_s) noexcept {
  const double x = std::min(age_s / kForesightAges_s[0], 1.0);
  return {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / kForesightAges_s[0]};
}

}  // namespace

MotionBasis motion_basis(const MotionModel& model, double age_s) noexcept {
  if (!model.moves) return {};
  const Progress age = lived(age_s, model.freeze_from_s);
  const double w = model.breathing_rad_per_s;
  const double fade = std::exp(-age.s / model.linear_fade_s);
  const double c1 = std::cos(w * age.s);
  const double s1 = std::sin(w * age.s);
  const double c2 = c1 * c1 - s1 * s1;
  const double s2 = 2.0 * s1 * c1;
  const Progress speed = believed(model.speed, age.s);
  const Progress acceleration = believed(model.acceleration, age.s);
  const Progress own = believed(model.own, age.s);
  const Progress linear{model.linear_fade_s * (1.0 - fade), fade};
  const Progress own_speed = product(own, speed);
  const std::array<Progress, kMotionTerms> terms = {product(own_speed, linear),
                                                    product(product(own, acceleration), {c1 - 1.0, -w * s1}),
                                                    product(own_speed, {s1, w * c1}),
                                                    product(own, {c2 - 1.0, -2.0 * w * s2}),
                                                    product(own, {s2, 2.0 * w * c2}),
                                                    product(believed(model.straight, age.s), linear),
                                                    product(believed(model.to_mean, age.s), way_to_mean(age.s))};
  MotionBasis basis;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    basis.value[i] = static_cast<float>(terms[i].s);
    basis.rate[i] = static_cast<float>(age.rate * terms[i].rate);
  }
  return basis;
}

}  // namespace telepalp::surface
