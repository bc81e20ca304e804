#pragma once

#include <optional>

#include "haptic_station/effects/effect_bank.h"

namespace telepalp::control {

/// The tool as the effects see it: at the device's point, with an attitude of its own.
///
/// On a device that measures an attitude and gives torques, the tool has the device's attitude. Most devices measure
/// six degrees of freedom and drive three. There the hand turns the handle without work, because no torque opposes it;
/// a turn that loaded a spring would therefore create energy, which the spring's force returns. So the tool is a proxy
/// for the attitude: it turns towards the device's attitude as far as this does not raise the energy of the effects,
/// and the torques that the device lacks do no work. A turn along an obstacle slides, and a turn that unloads a spring
/// is free. The tool has the same rule while it has not reached the device's attitude, for example when a device begins
/// to measure its attitude in the middle of a contact. Owner: haptic thread.
class VirtualTool {
 public:
  /// Contact begins: the tool has the device's attitude, or the last one that was measured.
  void begin(const std::optional<Eigen::Quaterniond>& device) noexcept;

  /// Turns the tool within a tick of `dt_s`, and returns `at_device` with the tool's attitude and rotation. `device`:
  /// the device's attitude; nullopt: not measured, and the tool rests. `gives_torque`: the device gives torques.
  [[nodiscard]] effects::EffectInput turn(const effects::EffectInput& at_device,
                                          const std::optional<Eigen::Quaterniond>& device,
                                          const effects::EffectBank& effects, bool gives_torque, double dt_s) noexcept;

  /// True while the tool has the attitude of a device that gives torques, so that the torque of the effects may be
  /// displayed.
  [[nodiscard]] bool shows_torque() const noexcept { return shows_torque_; }

 private:
  Eigen::Quaterniond attitude_ = Eigen::Quaterniond::Identity();
  bool reached_ = true;  ///< the device's attitude, in this contact
  bool shows_torque_ = false;
};

}  // namespace telepalp::control
