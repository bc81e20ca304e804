#pragma once

#include <memory>
#include <span>
#include <vector>

#include "haptic_station/core/effect_stage.h"
#include "haptic_station/core/prism_stage.h"
#include "haptic_station/effects/effect_bank.h"

namespace telepalp::core {

/// A scene's effects, ready for the haptic thread, and the slow stages that they own. Only one copy of the bank may be
/// stepped, because one consumer takes the stages' models.
template <class Kinds>
struct BuiltKinds {
  effects::BasicEffectBank<Kinds> bank;
  std::vector<std::unique_ptr<EffectStage>> stages;
};
using BuiltEffects = BuiltKinds<effects::Effect>;

/// Makes the effects of any list of kinds; build_effects() does it for telepalp's own.
template <class Kinds>
[[nodiscard]] BuiltKinds<Kinds> build_kinds(std::span<const typename effects::RecipesOf<Kinds>::Variant> recipes);

/// Makes a scene's effects of their recipes, in the same order. Nothing else in telepalp's programs makes an effect.
/// More than effects::kMostEffects recipes are left out; a scene that has more is refused when it is read.
[[nodiscard]] BuiltEffects build_effects(std::span<const effects::Recipe> recipes);

/// The bank of build_effects(), for a reader that drives no slow stage, such as the tracking of the skin above objects.
[[nodiscard]] inline effects::EffectBank bank_of(std::span<const effects::Recipe> recipes) {
  return build_effects(recipes).bank;
}

/// True if a slow stage computes one of the effects.
[[nodiscard]] inline bool has_slow_stage(std::span<const effects::Recipe> recipes) {
  return !build_effects(recipes).stages.empty();
}

/// The effect at index `I` or later of `Kinds` whose recipe is at the same index of `recipe`. Connects it to its slow
/// stage, if its kind owns one.
template <class Kinds, std::size_t I = 0>
[[nodiscard]] Kinds effect_of(const typename effects::RecipesOf<Kinds>::Variant& recipe,
                              std::vector<std::unique_ptr<EffectStage>>& stages) {
  using Kind = std::variant_alternative_t<I, Kinds>;
  if constexpr (I + 1 < std::variant_size_v<Kinds>)
    if (recipe.index() != I) return effect_of<Kinds, I + 1>(recipe, stages);
  Kind effect(std::get<I>(recipe));
  if constexpr (OwnsSlowStage<Kind>) {
    auto models = std::make_shared<LatestValue<typename Kind::LocalModel>>();
    effect.take_models(models);
    stages.push_back(std::make_unique<OwnedStage<Kind>>(std::get<I>(recipe), std::move(models)));
  }
  return effect;
}

template <class Kinds>
BuiltKinds<Kinds> build_kinds(std::span<const typename effects::RecipesOf<Kinds>::Variant> recipes) {
  BuiltKinds<Kinds> built;
  for (const auto& recipe : recipes.first(std::min(recipes.size(), effects::kMostEffects)))
    (void)built.bank.add(effect_of<Kinds>(recipe, built.stages));
  return built;
}

}  // namespace telepalp::core
