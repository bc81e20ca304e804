#pragma once

#include <algorithm>
#include <cmath>

#include "haptic_station/effects/effect_bank.h"

// Definitions of BasicEffectBank's members. Include this only in the file that instantiates the bank for a list of
/// kinds.

namespace telepalp::effects {

/// std::visit may throw, and the haptic thread must not; std::get_if never throws.
template <std::size_t I = 0, class Effect, class Do>
auto with(Effect& effect, Do&& act) noexcept {
  if constexpr (I + 1 < std::variant_size_v<std::remove_const_t<Effect>>) {
    if (effect.index() != I) return with<I + 1>(effect, act);
  }
  return act(*std::get_if<I>(&effect));
}

template <class Effect>
concept InnerObject = requires(const Effect& effect) {
  { effect.place() }
  noexcept;
};

/// The input as the effect feels it: an object inside the body feels the device relative to its displacement.
template <class Effect>
const EffectInput& felt_by(const Effect&, const EffectInput& in, const Placement&) noexcept {
  return in;
}
template <InnerObject Effect>
EffectInput felt_by(const Effect&, const EffectInput& in, const Placement& placement) noexcept {
  EffectInput felt = in;
  felt.device.m -= placement.moved.v;
  return felt;
}

template <class Effect>
concept IsSpring = requires(const Effect& effect) {
  { effect.pull(0.0) }
  noexcept;
};

template <class Effect>
concept HasState = requires(Effect& effect) {
  { effect.wrench(0.0, 1.0) }
  noexcept;
  { effect.stored_J() }
  noexcept;
};

template <class Effect>
concept HoldsForce = requires(const Effect& effect) {
  { effect.holds_N() }
  noexcept;
};

template <class Effect>
concept HasFriction = requires(const Effect& effect) {
  { effect.coefficient() }
  noexcept;
};

template <class Effect>
concept DamagesSkin = requires(const Effect& effect) {
  { effect.skin_left() }
  noexcept;
};

template <class Effect>
concept GrowsWithSkin = requires(Effect& effect) {
  { effect.weaken(1.0) }
  noexcept;
};

template <class Effect>
concept FeelsAttitude = requires(const Effect& effect, const EffectInput& in) {
  { effect.loaded_J(in) }
  noexcept;
};

/// `given`: a wrench, or a force without a torque.
template <class Given>
Wrench<HapticBase> as_wrench(const Given& given) noexcept {
  if constexpr (std::is_same_v<Given, Force<HapticBase>>)
    return {.force = given};
  else
    return given;
}

/// The effect's wrench with springs that are relaxed by `relaxed_m`, and the share `share` of what its state may hold.
template <class Effect>
Wrench<HapticBase> relaxed_wrench(Effect& effect, double relaxed_m, double share) noexcept {
  Wrench<HapticBase> sum;
  if constexpr (IsSpring<Effect>) sum = as_wrench(effect.force(relaxed_m));
  if constexpr (HasState<Effect>) {
    const Wrench<HapticBase> state = as_wrench(effect.wrench(relaxed_m, share));
    if constexpr (!IsSpring<Effect>) return state;
    sum.force.N += state.force.N;
    sum.torque.N_m += state.torque.N_m;
  }
  return sum;
}

template <class Effect>
double relaxed_energy_J(const Effect& effect, double relaxed_m) noexcept {
  double sum_J = 0.0;
  if constexpr (IsSpring<Effect>) sum_J += effect.energy_J(relaxed_m);
  if constexpr (HasState<Effect>) sum_J += effect.stored_J();
  return sum_J;
}

template <class Effect>
concept HasWall = requires(const Effect& effect, double dt_s) {
  { effect.wall_velocity(dt_s) }
  noexcept;
};

template <class Effect>
concept HasLabel = requires(const Effect& effect) {
  { effect.label() }
  noexcept;
};

template <class Effect>
Eigen::Vector3d carried_at(const Effect& effect, const EffectInput& in, const Placement& placement) noexcept {
  if constexpr (InnerObject<Effect>)
    return placement.velocity.v;
  else
    return effect.carried_at(in).v;
}

template <class Kinds>
std::optional<Point<HapticBase>> BasicEffectBank<Kinds>::object_at(std::size_t effect) const noexcept {
  if (effect >= count_) return std::nullopt;
  return with(effects_[effect], [](const auto& e) noexcept -> std::optional<Point<HapticBase>> {
    if constexpr (InnerObject<std::remove_cvref_t<decltype(e)>>)
      return e.place();
    else
      return std::nullopt;
  });
}

template <class Kinds>
void BasicEffectBank<Kinds>::find_proxies_with(const solids::ProxySettings& settings) noexcept {
  for (std::size_t i = 0; i < count_; ++i)
    if (Solid* solid = std::get_if<Solid>(&effects_[i])) solid->find_proxy_with(settings);
}

template <class Kinds>
const char* BasicEffectBank<Kinds>::name(const Effect& effect) noexcept {
  return with(effect, [](const auto& e) noexcept -> const char* {
    if constexpr (HasLabel<std::remove_cvref_t<decltype(e)>>)
      return e.label();
    else
      return std::remove_cvref_t<decltype(e)>::kName;
  });
}

template <class Kinds>
bool BasicEffectBank<Kinds>::add(const Effect& effect) noexcept {
  if (count_ == kMostEffects) return false;
  bill_[count_] = EffectBill{.name = name(effect)};
  with(effect, [this](const auto& e) noexcept {
    using Kind = std::remove_cvref_t<decltype(e)>;
    if constexpr (HasFriction<Kind>) friction_ += e.coefficient();
    feels_attitude_ = feels_attitude_ || FeelsAttitude<Kind>;
    weakens_skin_ = weakens_skin_ || DamagesSkin<Kind>;
  });
  effects_[count_++] = effect;
  return true;
}

template <class Kinds>
void BasicEffectBank<Kinds>::begin(const EffectInput& in) noexcept {
  held_ = {};
  relaxed_m_ = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](auto& e) noexcept { e.begin(felt_by(e, in, placements_[i])); });
  states_hold_N_ = held_by_states_N();
  if (weakens_skin_) weaken_skin(1.0);
}

template <class Kinds>
double BasicEffectBank<Kinds>::held_by_states_N() const noexcept {
  double sum_N = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (HoldsForce<std::remove_cvref_t<decltype(e)>>) sum_N += e.holds_N();
    });
  return sum_N;
}

template <class Kinds>
double BasicEffectBank<Kinds>::wanted_skin_left() const noexcept {
  double left = 1.0;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (DamagesSkin<std::remove_cvref_t<decltype(e)>>) left *= std::clamp(e.skin_left(), 0.0, 1.0);
    });
  return left;
}

template <class Kinds>
void BasicEffectBank<Kinds>::weaken_skin(double left) noexcept {
  skin_left_ = left;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](auto& e) noexcept {
      if constexpr (GrowsWithSkin<std::remove_cvref_t<decltype(e)>>) e.weaken(left);
    });
}

template <class Kinds>
double BasicEffectBank<Kinds>::loaded_J(const EffectInput& in) const noexcept {
  double sum_J = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (FeelsAttitude<std::remove_cvref_t<decltype(e)>>)
        sum_J += e.loaded_J(felt_by(e, in, placements_[i]));
    });
  return sum_J;
}

/// Steps each effect, and adds up the work of the wrenches that it held over the tick that ends now. Lowering the
/// skin's stiffness takes energy out of it; raising it would create energy, so its share only falls.
template <class Kinds>
void BasicEffectBank<Kinds>::advance(const EffectInput& in, double dt_s, CostClock clock) noexcept {
  absorbed_J_ = 0.0;
  if (weakens_skin_)
    if (const double left = wanted_skin_left(); left < skin_left_) weaken_skin(left);
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint64_t before = clock != nullptr ? clock() : 0;
    with(effects_[i], [&](auto& e) noexcept {
      const EffectInput& felt = felt_by(e, in, placements_[i]);
      const Eigen::Vector3d carried = carried_at(e, in, placements_[i]);
      absorbed_J_ -= held_[i].force_N.dot(in.moved.v - 0.5 * dt_s * (held_[i].carried_at + carried));
      if constexpr (HasWall<std::remove_cvref_t<decltype(e)>>)
        absorbed_J_ += dt_s * held_[i].force_N.dot(e.wall_velocity(dt_s).v);
      if constexpr (FeelsAttitude<std::remove_cvref_t<decltype(e)>>)
        absorbed_J_ -= held_[i].torque_N_m.dot(in.turn.turned.v);
      const Wrench<HapticBase> now = as_wrench(e.step(felt, dt_s));
      held_[i] = {now.force.N, now.torque.N_m, carried};
    });
    const std::uint64_t cost = clock != nullptr ? clock() - before : 0;
    ++bill_[i].steps;
    bill_[i].cost += cost;
    bill_[i].largest = std::max(bill_[i].largest, cost);
  }
}

template <class Kinds>
Wrench<HapticBase> BasicEffectBank<Kinds>::step(const EffectInput& in, double dt_s, double most_N,
                                                CostClock clock) noexcept {
  advance(in, dt_s, clock);
  const double bound_N = std::max(0.0, most_N);
  const double share = states_hold_N_ > bound_N ? bound_N / states_hold_N_ : 1.0;
  // Friction acts perpendicular to the skin's force, with at most `friction_` times the magnitude of that force.
  springs_most_N_ = std::max(0.0, bound_N - states_hold_N_) / std::sqrt(1.0 + friction_ * friction_);
  relaxed_m_ = common_relaxation_m([this](double relaxed_m) noexcept { return pull(relaxed_m); }, springs_most_N_);
  Wrench<HapticBase> sum;
  for (std::size_t i = 0; i < count_; ++i) {
    if (relaxed_m_ > 0.0 || share < 1.0) {
      const auto relaxed = with(effects_[i], [&](auto& e) noexcept { return relaxed_wrench(e, relaxed_m_, share); });
      held_[i].force_N = relaxed.force.N;
      held_[i].torque_N_m = relaxed.torque.N_m;
    }
    sum.force.N += held_[i].force_N;
    sum.torque.N_m += held_[i].torque_N_m;
  }
  return sum;
}

template <class Kinds>
double BasicEffectBank<Kinds>::energy_J() const noexcept {
  double sum_J = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    sum_J += with(effects_[i], [&](const auto& e) noexcept { return relaxed_energy_J(e, relaxed_m_); });
  return sum_J;
}

template <class Kinds>
Pull BasicEffectBank<Kinds>::pull(double relaxed_m) const noexcept {
  Pull sum;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (IsSpring<std::remove_cvref_t<decltype(e)>>) sum += e.pull(relaxed_m);
    });
  return sum;
}

template <class Kinds>
Force<HapticBase> BasicEffectBank<Kinds>::change_with_skin_at(const Eigen::Vector3d& indentation_m) const noexcept {
  const Skin* own = skin();
  if (own == nullptr) return {};
  const auto pull_at = [&](double relaxed_m) noexcept {
    Pull sum = pull(relaxed_m);
    sum -= own->pull(relaxed_m);
    return sum += skin_pull(own->law(), indentation_m, relaxed_m);
  };
  const double relaxed_m = common_relaxation_m(pull_at, springs_most_N_);
  Force<HapticBase> change{skin_force_N(own->law(), indentation_m, relaxed_m) - own->force(relaxed_m_).N};
  if (relaxed_m == relaxed_m_) return change;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (IsSpring<std::remove_cvref_t<decltype(e)>>)
        if (static_cast<const void*>(&e) != own)
          change.N += as_wrench(e.force(relaxed_m)).force.N - as_wrench(e.force(relaxed_m_)).force.N;
    });
  return change;
}

template <class Kinds>
double BasicEffectBank<Kinds>::stiffest_N_per_m(double most_N) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    sum += with(effects_[i], [&](const auto& e) noexcept { return e.stiffest_N_per_m(most_N); });
  return sum;
}

template <class Kinds>
ObjectTouch BasicEffectBank<Kinds>::touch() const noexcept {
  ObjectTouch nearest = ObjectTouch::None;
  for (std::size_t i = 0; i < count_; ++i)
    nearest = std::max(nearest, with(effects_[i], [](const auto& e) noexcept { return e.touch(); }));
  return nearest;
}

template <class Kinds>
const Skin* BasicEffectBank<Kinds>::skin() const noexcept {
  for (std::size_t i = 0; i < count_; ++i)
    if (const Skin* skin = std::get_if<Skin>(&effects_[i])) return skin;
  return nullptr;
}

template <class Kinds>
Vector<HapticBase> BasicEffectBank<Kinds>::indentation() const noexcept {
  const Skin* first = skin();
  return first != nullptr ? first->indentation() : Vector<HapticBase>{};
}

}  // namespace telepalp::effects
