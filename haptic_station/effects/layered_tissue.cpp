#include "haptic_station/effects/layered_tissue.h"

#include <algorithm>

namespace telepalp::effects {

using Eigen::Vector3d;

tissue::NeedleMotion LayeredTissue::needle(const EffectInput& in) const noexcept {
  const Vector3d axis = settings_.tip_m.isZero() ? Vector3d(-Vector3d::UnitY()) : settings_.tip_m.normalized();
  const Vector3d beside = std::abs(axis.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitZ();
  return {.tip_m = in.device.m + in.turn.attitude * settings_.tip_m,
          .axis = in.turn.attitude * axis,
          .bevel = in.turn.attitude * (beside - beside.dot(axis) * axis).normalized()};
}

void LayeredTissue::begin(const EffectInput& in) noexcept {
  N_per_N_m_ = in.turn.N_per_N_m;
  weight_ = lever_weight(settings_.tip_m.norm(), N_per_N_m_);
  lever_m_ = in.turn.attitude * settings_.tip_m;
  if (settings_.model) tissue_.begin(needle(in));
}

Wrench<HapticBase> LayeredTissue::step(const EffectInput& in, double dt_s) noexcept {
  if (!settings_.model) return {};
  lever_m_ = in.turn.attitude * settings_.tip_m;
  (void)tissue_.step(needle(in), dt_s);
  return wrench(0.0, 1.0);
}

/// The tissue yields until its wrench is within bounds. A net's stiffening part falls with the square of the extension,
/// faster than the force that yield() is asked for, so one round usually suffices.
Wrench<HapticBase> LayeredTissue::wrench(double, double share) noexcept {
  constexpr int kMostRounds = 4;
  if (!settings_.model) return {};
  const double most_N = share * holds_N();
  Wrench<HapticBase> out;
  for (int round = 0; round < kMostRounds; ++round) {
    const tissue::TissueWrench at_tip = tissue_.wrench();
    out = {.force = {at_tip.force_N}, .torque = {at_tip.torque_N_m + lever_m_.cross(at_tip.force_N)}};
    const double asks_N = std::max(out.force.N.norm(), N_per_N_m_ * out.torque.N_m.norm());
    if (asks_N <= most_N) break;
    tissue_.yield(most_N / asks_N);
  }
  return out;
}

/// A copy takes a step of no duration: nothing relaxes, and a net that this step punctures keeps its energy, so that
/// the energy of a turn does not fall at a puncture.
double LayeredTissue::loaded_J(const EffectInput& in) const noexcept {
  if (!settings_.model) return 0.0;
  tissue::LayeredTissue turned = tissue_;
  (void)turned.step(needle(in), 0.0);
  return turned.stored_J();
}

double LayeredTissue::skin_left() const noexcept {
  return settings_.model ? 1.0 - tissue_.opened() * (1.0 - settings_.skin_left) : 1.0;
}

Point<HapticBase> LayeredTissue::place() const noexcept {
  return settings_.model ? Point<HapticBase>{tissue::settings_of(*settings_.model).at_m} : Point<HapticBase>{};
}

ObjectTouch LayeredTissue::touch() const noexcept {
  if (!settings_.model) return ObjectTouch::None;
  for (std::size_t i = 0; i < tissue_.size(); ++i)
    if (tissue_.layer(i).state == tissue::LayerState::Touching) return ObjectTouch::Upper;
  return ObjectTouch::None;
}

}  // namespace telepalp::effects
