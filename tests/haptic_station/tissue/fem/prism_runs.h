#pragma once

#include <functional>
#include <memory>

#include "haptic_station/core/prism_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/effects/fem_prism.h"
#include "tests/haptic_station/tissue/fem/hand_over.h"
#include "tests/haptic_station/tissue/fem/prisms.h"

namespace telepalp::tissue {

/// The effect and its slow stage in virtual time, with a tool that is moved. A second account, by the effect's springs
/// alone, checks what is booked.
class PrismRun {
 public:
  explicit PrismRun(const effects::FemPrismSettings& settings, const Eigen::Vector3d& from_m)
      : models_(std::make_shared<LatestValue<LocalPlane>>()),
        stage_(std::make_unique<core::OwnedStage<effects::FemPrism>>(settings, models_)),
        effect_(settings) {
    effect_.take_models(models_);
    in_.device.m = from_m;
    effect_.begin(in_);
  }
  /// `cost`: time from the begin of a run of the stage to its hand-over.
  void tick(const Eigen::Vector3d& to_m, Nanoseconds cost) {
    if (auto result = driver_.finished(now_)) {
      stage_->hand_over(std::move(*result));
      ++handed_over_;
    }
    driver_.begin(
        now_, *stage_, [cost](core::StageStep) { return cost; }, core::ToolAt{{in_.device}});
    const SlewedPlane before = effect_.plane();
    const Eigen::Vector3d by_m = to_m - in_.device.m;
    const double carried_m = std::max(0.0, before.signed_depth_m() - before.normal().dot(by_m));
    const double carried_J = 0.5 * before.stiffness_N_per_m() * carried_m * carried_m;
    in_.device.m = to_m;
    force_N_ = effect_.step(in_, kTickOfPlane_s).N;
    const SlewedPlane& after = effect_.plane();
    const double added_J = after.energy_J() - carried_J;
    const auto booked = [](const SlewedPlane& plane) { return plane.tank().paid_J() - plane.tank().filled_J(); };
    added_J_ += added_J;
    unbooked_J_ += std::abs(added_J - (booked(after) - booked(before)));
    const double spring = std::max(before.stiffness_N_per_m(), after.stiffness_N_per_m());
    worst_step_N_ =
        std::max(worst_step_N_, (force_N_ - before.force_N() * before.normal()).norm() - spring * by_m.norm());
    least_tank_J_ = std::min(least_tank_J_, after.tank().level_J());
    now_ += std::chrono::microseconds(500);
  }

  [[nodiscard]] const Eigen::Vector3d& force_N() const { return force_N_; }
  [[nodiscard]] const Eigen::Vector3d& at_m() const { return in_.device.m; }
  [[nodiscard]] effects::FemPrism& effect() { return effect_; }
  [[nodiscard]] int handed_over() const { return handed_over_; }
  [[nodiscard]] double added_J() const { return added_J_; }            ///< by models, at a resting tool
  [[nodiscard]] double unbooked_J() const { return unbooked_J_; }      ///< sum over the ticks
  [[nodiscard]] double worst_step_N() const { return worst_step_N_; }  ///< |change of force| - stiffness × |motion|
  [[nodiscard]] double least_tank_J() const { return least_tank_J_; }

 private:
  std::shared_ptr<LatestValue<LocalPlane>> models_;
  std::unique_ptr<core::EffectStage> stage_;
  core::VirtualDriver<core::EffectStage> driver_;
  effects::FemPrism effect_;
  effects::EffectInput in_;
  SessionTime now_{std::chrono::seconds(10)};
  Eigen::Vector3d force_N_ = Eigen::Vector3d::Zero();
  int handed_over_ = 0;
  double added_J_ = 0.0;
  double unbooked_J_ = 0.0;
  double worst_step_N_ = 0.0;
  double least_tank_J_ = 1e9;
};

/// A hand that presses the right side of a prism of 20 × 20 × 100 mm 90 mm above its foot: from 5 mm beside it to 15 mm
/// into it and back, in 0.2 pi seconds, at up to 0.1 m/s.
inline Eigen::Vector3d pressing_at(double time_s) {
  constexpr double kHalf_m = 0.01;
  constexpr double kFastest_m_per_s = 0.1;
  return {0.015 - kHalf_m * (1.0 - std::cos(kFastest_m_per_s / kHalf_m * time_s)), 0.09, 0.0};
}
inline constexpr double kPressing_s = 0.62831853071795865;

}  // namespace telepalp::tissue
