#include "haptic_station/effects/effect_bank.h"

#include <algorithm>
#include <cmath>

namespace telepalp::effects {
namespace {

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

template <IsSpring Effect>
Force<HapticBase> relaxed_force(const Effect& effect, double relaxed_m) noexcept {
  return effect.force(relaxed_m);
}
Force<HapticBase> relaxed_force(Friction& friction, double relaxed_m) noexcept { return friction.slip(relaxed_m); }

template <IsSpring Effect>
double relaxed_energy_J(const Effect& effect, double relaxed_m) noexcept {
  return effect.energy_J(relaxed_m);
}
double relaxed_energy_J(const Friction& friction, double) noexcept { return friction.energy_J(); }

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

}  // namespace

std::optional<Point<HapticBase>> EffectBank::object_at(std::size_t effect) const noexcept {
  if (effect >= count_) return std::nullopt;
  return with(effects_[effect], [](const auto& e) noexcept -> std::optional<Point<HapticBase>> {
    if constexpr (InnerObject<std::remove_cvref_t<decltype(e)>>)
      return e.place();
    else
      return std::nullopt;
  });
}

void EffectBank::find_proxies_with(const solids::ProxySettings& settings) noexcept {
  for (std::size_t i = 0; i < count_; ++i)
    if (Solid* solid = std::get_if<Solid>(&effects_[i])) solid->find_proxy_with(settings);
}

const char* EffectBank::name(const Effect& effect) noexcept {
  return with(effect, [](const auto& e) noexcept -> const char* {
    if constexpr (HasLabel<std::remove_cvref_t<decltype(e)>>)
      return e.label();
    else
      return std::remove_cvref_t<decltype(e)>::kName;
  });
}

bool EffectBank::add(const Effect& effect) noexcept {
  if (count_ == kMostEffects) return false;
  bill_[count_] = EffectBill{.name = name(effect)};
  if (const Friction* friction = std::get_if<Friction>(&effect)) friction_ += friction->coefficient();
  effects_[count_++] = effect;
  return true;
}

void EffectBank::begin(const EffectInput& in) noexcept {
  held_ = {};
  relaxed_m_ = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](auto& e) noexcept { e.begin(felt_by(e, in, placements_[i])); });
}

/// Steps each effect, and adds up the work of the forces that it held over the tick that ends now.
void EffectBank::advance(const EffectInput& in, double dt_s, CostClock clock) noexcept {
  absorbed_J_ = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint64_t before = clock != nullptr ? clock() : 0;
    with(effects_[i], [&](auto& e) noexcept {
      const EffectInput& felt = felt_by(e, in, placements_[i]);
      const Eigen::Vector3d carried = carried_at(e, in, placements_[i]);
      absorbed_J_ -= held_[i].force_N.dot(in.moved.v - 0.5 * dt_s * (held_[i].carried_at + carried));
      if constexpr (HasWall<std::remove_cvref_t<decltype(e)>>)
        absorbed_J_ += dt_s * held_[i].force_N.dot(e.wall_velocity(dt_s).v);
      held_[i] = {e.step(felt, dt_s).N, carried};
    });
    const std::uint64_t cost = clock != nullptr ? clock() - before : 0;
    ++bill_[i].steps;
    bill_[i].cost += cost;
    bill_[i].largest = std::max(bill_[i].largest, cost);
  }
}

Force<HapticBase> EffectBank::step(const EffectInput& in, double dt_s, double most_N, CostClock clock) noexcept {
  advance(in, dt_s, clock);
  // Friction acts perpendicular to the skin's force, with at most `friction_` times the magnitude of that force.
  springs_most_N_ = std::max(0.0, most_N) / std::sqrt(1.0 + friction_ * friction_);
  relaxed_m_ = common_relaxation_m([this](double relaxed_m) noexcept { return pull(relaxed_m); }, springs_most_N_);
  Force<HapticBase> sum;
  for (std::size_t i = 0; i < count_; ++i) {
    if (relaxed_m_ > 0.0)
      held_[i].force_N = with(effects_[i], [&](auto& e) noexcept { return relaxed_force(e, relaxed_m_).N; });
    sum.N += held_[i].force_N;
  }
  return sum;
}

double EffectBank::energy_J() const noexcept {
  double sum_J = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    sum_J += with(effects_[i], [&](const auto& e) noexcept { return relaxed_energy_J(e, relaxed_m_); });
  return sum_J;
}

Pull EffectBank::pull(double relaxed_m) const noexcept {
  Pull sum;
  for (std::size_t i = 0; i < count_; ++i)
    with(effects_[i], [&](const auto& e) noexcept {
      if constexpr (IsSpring<std::remove_cvref_t<decltype(e)>>) sum += e.pull(relaxed_m);
    });
  return sum;
}

Force<HapticBase> EffectBank::change_with_skin_at(const Eigen::Vector3d& indentation_m) const noexcept {
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
        if (static_cast<const void*>(&e) != own) change.N += e.force(relaxed_m).N - held_[i].force_N;
    });
  return change;
}

double EffectBank::stiffest_N_per_m(double most_N) const noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    sum += with(effects_[i], [&](const auto& e) noexcept { return e.stiffest_N_per_m(most_N); });
  return sum;
}

ObjectTouch EffectBank::touch() const noexcept {
  ObjectTouch nearest = ObjectTouch::None;
  for (std::size_t i = 0; i < count_; ++i)
    nearest = std::max(nearest, with(effects_[i], [](const auto& e) noexcept { return e.touch(); }));
  return nearest;
}

const Skin* EffectBank::skin() const noexcept {
  for (std::size_t i = 0; i < count_; ++i)
    if (const Skin* skin = std::get_if<Skin>(&effects_[i])) return skin;
  return nullptr;
}

Vector<HapticBase> EffectBank::indentation() const noexcept {
  const Skin* first = skin();
  return first != nullptr ? first->indentation() : Vector<HapticBase>{};
}

}  // namespace telepalp::effects
