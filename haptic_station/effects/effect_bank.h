#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "haptic_station/effects/effect_list.h"

namespace telepalp::effects {

/// Reads a clock without a system call, in any unit. nullptr: the cost of effects is not measured.
using CostClock = std::uint64_t (*)() noexcept;

/// Measured cost of one effect's steps: their number, their total cost and the largest, in the unit of the CostClock.
struct EffectBill {
  const char* name = "";
  std::uint64_t steps = 0;
  std::uint64_t cost = 0;
  std::uint64_t largest = 0;
};

/// The effects of a scene, in the order of the scene file. Limits the sum of their forces to what the device can give.
/// core::build_effects() builds it from a scene's recipes. `Kinds`: a std::variant of all kinds of effects; a test may
/// add a kind of its own. Owner: haptic thread.
///
/// Each effect except friction is one or more springs with a depth d, a force of magnitude f(d) and the energy U(d).
/// While the magnitudes of all springs sum to more than B, the largest force that the device can give, all springs are
/// relaxed by one common depth m, so that their f(d - m) sum to B. These forces are the gradient of h = sum of
/// (U(d - m) + m f(d - m)), which is the supremum of the sum of (p d - U*(p)) over all magnitudes p >= 0 that sum to at
/// most B; U* is a spring's complementary energy. The forces are therefore conservative for any directions of the
/// springs, and their vector sum is at most B. Scaling the vector sum down to B would not be conservative: where the
/// directions of two springs change with the device's place, a hand on a closed path could gain energy. A spring with a
/// torque counts by its weight (LeverSpring), so that one common depth bounds force and torque. Effects with a state
/// (effect.h) keep the part of B that they may need, their holds_N().
template <class Kinds>
class BasicEffectBank {
 public:
  static constexpr std::size_t kMostEffects = effects::kMostEffects;
  using Effect = Kinds;

  /// False when the bank is full.
  bool add(const Effect& effect) noexcept;
  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  /// Displaces the objects inside the body, from the next begin() or step() on.
  void place(const Placements& placements) noexcept { std::copy_n(placements.begin(), count_, placements_.begin()); }
  /// Finds the proxies of all solids with `settings`, from the next begin() on: to compare the usual settings with
  /// finer ones.
  void find_proxies_with(const solids::ProxySettings& settings) noexcept;
  /// Where the scene puts the effect's object; nullopt: the effect is not an object inside the body.
  [[nodiscard]] std::optional<Point<HapticBase>> object_at(std::size_t effect) const noexcept;

  /// The end-effector has just entered the body.
  void begin(const EffectInput& in) noexcept;
  /// The sum of all effects' wrenches on the hand. `most_N`: the largest force that the device gives now. The largest
  /// torque is in the same proportion to it as at the beginning of the contact (ToolTurn::N_per_N_m).
  [[nodiscard]] Wrench<HapticBase> step(const EffectInput& in, double dt_s,
                                        double most_N = std::numeric_limits<double>::infinity(),
                                        CostClock clock = nullptr) noexcept;
  /// True when an effect depends on the tool's attitude.
  [[nodiscard]] bool feels_attitude() const noexcept { return feels_attitude_; }
  /// The energy that the effects which depend on the attitude would store with this input.
  [[nodiscard]] double loaded_J(const EffectInput& in) const noexcept;
  /// Share of the skin's stiffness that the effects have left in this contact.
  [[nodiscard]] double skin_left() const noexcept { return skin_left_; }
  /// Energy that the hand could get back while the bound `most_N` of the last step() lasts: h plus the energy of
  /// the effects' states.
  [[nodiscard]] double energy_J() const noexcept;
  /// The depth by which all springs are relaxed at the last step; 0: they act in full.
  [[nodiscard]] double relaxed_m() const noexcept { return relaxed_m_; }
  /// Work that the effects took from the hand during the last tick [J]: for each effect, minus the force held over the
  /// tick times the motion of the device relative to the skin, object or wall to which the effect is fixed, and minus
  /// the torque held times the tool's rotation; then the sum. It is exact for a held wrench, so it includes the energy
  /// that sampling creates.
  [[nodiscard]] double absorbed_J() const noexcept { return absorbed_J_; }
  /// Upper bound of the combined stiffness of all effects, at forces up to `most_N`.
  [[nodiscard]] double stiffest_N_per_m(double most_N) const noexcept;
  [[nodiscard]] ObjectTouch touch() const noexcept;  ///< the greatest value of all objects, in the enumerators' order
  [[nodiscard]] const Skin* skin() const noexcept;   ///< the first skin effect; nullptr without a skin
  /// The indentation of skin(), paper S1 (docs/sources.md) eq. (8) [m]; zero without a skin.
  [[nodiscard]] Vector<HapticBase> indentation() const noexcept;
  /// The force of the springs if the indentation of skin() were `indentation_m`, minus their force in the last step();
  /// zero without a skin.
  [[nodiscard]] Force<HapticBase> change_with_skin_at(const Eigen::Vector3d& indentation_m) const noexcept;
  [[nodiscard]] std::span<const EffectBill> bill() const noexcept { return {bill_.data(), count_}; }
  /// For a Solid, the layer's name in the scene; for other effects, the name of their kind. Valid as long as the
  /// effect.
  [[nodiscard]] static const char* name(const Effect& effect) noexcept;

 private:
  /// An effect's wrench, and the velocity of the body to which the effect is fixed, over the tick that ends now.
  struct Held {
    Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
    Eigen::Vector3d torque_N_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d carried_at = Eigen::Vector3d::Zero();
  };

  void weaken_skin(double left) noexcept;
  [[nodiscard]] double wanted_skin_left() const noexcept;
  [[nodiscard]] double held_by_states_N() const noexcept;
  void advance(const EffectInput& in, double dt_s, CostClock clock) noexcept;
  [[nodiscard]] Pull pull(double relaxed_m) const noexcept;  ///< of all springs

  std::array<Effect, kMostEffects> effects_{};
  Placements placements_{};
  std::array<EffectBill, kMostEffects> bill_{};
  std::array<Held, kMostEffects> held_{};
  std::size_t count_ = 0;
  double friction_ = 0.0;       ///< sum of the coefficients of friction
  double states_hold_N_ = 0.0;  ///< sum of holds_N() of all states in this contact
  double skin_left_ = 1.0;
  bool feels_attitude_ = false;
  bool weakens_skin_ = false;
  double springs_most_N_ = std::numeric_limits<double>::infinity();
  double relaxed_m_ = 0.0;
  double absorbed_J_ = 0.0;
};

/// The bank of telepalp's own kinds.
using EffectBank = BasicEffectBank<Effect>;
extern template class BasicEffectBank<Effect>;

}  // namespace telepalp::effects
