#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <variant>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/effects/bank/bank_steps.h"

namespace telepalp::core {

/// What the stage finds below the tool: level ground.
struct LocalGround {
  double height_m = 0.0;  ///< y in H
};

struct FeltGroundSettings {
  double stiffness_N_per_m = 400.0;
  /// The slow computation: the ground's height under a point of H [m].
  std::function<double(const Eigen::Vector3d&)> height_at = [](const Eigen::Vector3d&) { return 0.0; };
};

/// An effect that knows the tissue only by the local models of a slow stage. A new model that is higher raises the
/// ground by at most 50 mm/s; a lower one lowers it at once. If no model has come for 0.1 s, the ground sinks to the
/// device and gives no force.
class FeltGround {
 public:
  static constexpr const char* kName = "felt_ground";
  static constexpr double kSpeed_m_per_s = 0.05;
  static constexpr double kOld_s = 0.1;
  using Settings = FeltGroundSettings;
  using LocalModel = LocalGround;

  FeltGround() noexcept = default;
  explicit FeltGround(const Settings& settings) noexcept : stiffness_N_per_m_(settings.stiffness_N_per_m) {}
  void take_models(std::shared_ptr<LatestValue<LocalModel>> from) noexcept { models_ = std::move(from); }

  void begin(const effects::EffectInput&) noexcept {}
  [[nodiscard]] Force<HapticBase> step(const effects::EffectInput& in, double dt_s) noexcept {
    age_s_ += dt_s;
    if (models_ && models_->take()) {
      age_s_ = 0.0;
      ++taken_;
      wanted_m_ = models_->current().height_m;
      if (taken_ == 1) ground_m_ = std::min(wanted_m_, in.device.m.y());
    }
    const double before_m = ground_m_;
    if (age_s_ > kOld_s) wanted_m_ = std::min(wanted_m_, in.device.m.y());
    ground_m_ = std::min(ground_m_ + kSpeed_m_per_s * dt_s, wanted_m_);
    speed_m_per_s_ = taken_ == 0 ? 0.0 : (ground_m_ - before_m) / dt_s;
    const double deep_m = taken_ == 0 ? 0.0 : std::max(0.0, ground_m_ - in.device.m.y());
    spring_ = {stiffness_N_per_m_, deep_m, Eigen::Vector3d::UnitY()};
    return spring_.force(0.0);
  }
  [[nodiscard]] effects::Pull pull(double relaxed_m) const noexcept { return spring_.pull(relaxed_m); }
  [[nodiscard]] Force<HapticBase> force(double relaxed_m) const noexcept { return spring_.force(relaxed_m); }
  [[nodiscard]] double energy_J(double relaxed_m) const noexcept { return spring_.energy_J(relaxed_m); }
  [[nodiscard]] double stiffest_N_per_m(double) const noexcept { return stiffness_N_per_m_; }
  [[nodiscard]] effects::ObjectTouch touch() const noexcept { return effects::ObjectTouch::None; }
  [[nodiscard]] Vector<HapticBase> carried_at(const effects::EffectInput&) const noexcept {
    return {Eigen::Vector3d(0.0, speed_m_per_s_, 0.0)};
  }

 private:
  double stiffness_N_per_m_ = 0.0;
  std::shared_ptr<LatestValue<LocalModel>> models_;
  effects::LinearSpring spring_;
  double wanted_m_ = 0.0;
  double ground_m_ = 0.0;
  double speed_m_per_s_ = 0.0;
  double age_s_ = 0.0;
  int taken_ = 0;
};

struct FeltGroundStage {
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(10);

  explicit FeltGroundStage(const FeltGroundSettings& settings) : height_at(settings.height_at) {}
  [[nodiscard]] std::optional<LocalGround> model_at(const ModelWanted& wanted) {
    return LocalGround{height_at(wanted.tool.device.m)};
  }

  std::function<double(const Eigen::Vector3d&)> height_at;
};

template <>
struct SlowStageOf<FeltGround> {
  using Stage = FeltGroundStage;
};

/// telepalp's own kinds and one more: the line that registers it.
template <class Kinds, class More>
struct WithKind;
template <class... Kinds, class More>
struct WithKind<std::variant<Kinds...>, More> {
  using List = std::variant<Kinds..., More>;
};
using KindsWithGround = WithKind<effects::Effect, FeltGround>::List;
using GroundRecipe = effects::RecipesOf<KindsWithGround>::Variant;

}  // namespace telepalp::core
