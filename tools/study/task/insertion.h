#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "haptic_station/tissue/layered_tissue.h"
#include "tools/study/task/tools.h"

namespace telepalp::study {

/// What an insertion led to.
struct Outcome {
  bool through = false;  ///< the sac was punctured
  bool stopped = false;  ///< after the puncture, the tip stopped before kLongest_s
  double overshoot_m =
      0.0;  ///< from the place of contact with the sac to where the tip stopped, along the needle at contact
  double deepest_m = 0.0;            ///< as overshoot_m, but to the deepest place that the tip reached
  double depth_at_puncture_m = 0.0;  ///< depth of the tip below the skin at the puncture
  double hand_drop_N = 0.0;          ///< how far the force on the hand falls at the puncture
  double most_hand_N = 0.0;          ///< largest force of the needle on the hand
  double seconds = 0.0;
  bool noticed = false;  ///< the operator noticed the puncture; always false for a person, of whom it is not known
};

inline constexpr double kTick_s = 0.0005;
/// The tip has stopped when it moves by less than 0.2 mm in 0.1 s. S4 takes successive equal coordinates of its device,
/// which a hand with tremor does not give.
inline constexpr double kStoppedMove_m = 0.0002;
inline constexpr double kStoppedOver_s = 0.1;
/// An insertion ends after this time whatever happens.
inline constexpr double kLongest_s = 30.0;

/// One insertion at 2 kHz, whoever moves the hand: a simulated operator, a person at a haptic device, or a person in a
/// browser. S4 section 6: the tip begins outside the skin, goes through three layers, and stops as soon as possible.
/// Contact point, stop and overshoot are defined here alone. Pure; a step neither allocates, locks nor throws.
class Insertion {
 public:
  /// `tool`: with the tip outside; it must outlive this object. `tissue`: made of tissue_of().
  Insertion(HeldTool& tool, const std::shared_ptr<const tissue::TissueModel>& tissue) noexcept;

  /// One tick, at whose end the hand is at `hand_m`. After over(), it changes neither time nor outcome.
  void step(const Eigen::Vector3d& hand_m) noexcept;

  /// The tip has stopped after the puncture, or kLongest_s has passed.
  [[nodiscard]] bool over() const noexcept { return out_.stopped || ticks_ >= kMostTicks; }
  [[nodiscard]] Outcome outcome() const noexcept;
  [[nodiscard]] bool through() const noexcept { return out_.through; }
  [[nodiscard]] double time_s() const noexcept { return ticks_ * kTick_s; }
  [[nodiscard]] double depth_m() const noexcept { return -tool_.tip_m().y(); }
  /// Depth of the tip below the skin at the puncture; 0 before it.
  [[nodiscard]] double depth_at_puncture_m() const noexcept { return out_.depth_at_puncture_m; }
  /// Force of the needle on the hand.
  [[nodiscard]] const Eigen::Vector3d& needle_N() const noexcept { return needle_N_; }
  /// Force on a hand that feels: of the needle, and of the mechanism that keeps the hand on its path.
  [[nodiscard]] Eigen::Vector3d felt_N() const noexcept { return needle_N_ + tool_.guide_force_N(); }
  [[nodiscard]] const HeldTool& tool() const noexcept { return tool_; }
  [[nodiscard]] const tissue::LayeredTissue& tissue() const noexcept { return tissue_; }

 private:
  static constexpr int kMostTicks = static_cast<int>(kLongest_s / kTick_s);
  static constexpr auto kWindow = static_cast<std::size_t>(kStoppedOver_s / kTick_s);
  void note_sac(double before_N) noexcept;
  [[nodiscard]] double way_past_contact_m() const noexcept;
  [[nodiscard]] bool stands_still() noexcept;

  HeldTool& tool_;
  tissue::LayeredTissue tissue_;
  Outcome out_;
  Eigen::Vector3d needle_N_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d contact_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_ = -Eigen::Vector3d::UnitY();
  bool touched_ = false;
  double before_N_ = 0.0;                          // force of the sac alone on the hand, at the tick before
  std::array<Eigen::Vector3d, kWindow> tips_m_{};  // over the last kStoppedOver_s
  std::size_t tips_ = 0;
  int ticks_ = 0;
};

/// A mechanism with its needle above whole tissue, and the insertion that begins.
struct Prepared {
  std::unique_ptr<HeldTool> tool;
  std::unique_ptr<Insertion> insertion;  ///< refers to `tool`
};

/// Who moves the hand in an insertion.
class HandMotion {
 public:
  virtual ~HandMotion() = default;
  /// Where the hand is at the end of the next tick [m].
  [[nodiscard]] virtual Eigen::Vector3d next_m(const Insertion& insertion) noexcept = 0;
};

}  // namespace telepalp::study
