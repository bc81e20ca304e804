#pragma once

#include <optional>

#include "haptic_station/tracking/hover/skin_heights.h"
#include "proto/words/frames.h"

namespace telepalp::tracking {

/// The path of a hand that a person moves with a pointer in a browser. A pointer can jump, and the straight line
/// between two places of the skin leads through the patient. So this hand moves at the speed of a real hand. While the
/// person does not press, it flies over the patient at a height over the skin, and so does the device below it: the
/// hand crosses a place only when the device is above everything that is seen around that place. A hand that begins to
/// press flies on until it is over the place, then comes down slowly, then follows. Pure; real-time safe. All positions
/// are in H, the haptic base's frame; y points up.
class GuidedHand {
 public:
  static constexpr double kFastest_m_per_s = 0.5;

  struct Wanted {
    Point<HapticBase> at;
    bool hovers = false;  ///< the person points at a place and does not press; false also for a hand that is tracked
  };
  struct Guided {
    Point<HapticBase> hand;
    /// Height [m] at which the free device waits under this hand; nullopt: the scene's plane decides, because the hand
    /// does not fly, or nothing is seen here.
    std::optional<double> wait_at_m;
  };

  /// The hand `dt_s` after the last call, or `device` at the first call. `device`: the end-effector now. `skin`: what
  /// the camera saw last.
  [[nodiscard]] Guided follow(const Wanted& wanted, const Point<HapticBase>& device, const SkinHeights& skin,
                              double dt_s) noexcept;

 private:
  enum class Way {
    Follows,    ///< straight to the wanted position
    Flies,      ///< over everything that is seen
    ComesDown,  ///< slowly to the wanted height, above the wanted place
  };

  void choose_way(const Wanted& wanted, const Point<HapticBase>& device) noexcept;
  void fly(const Wanted& wanted, const Point<HapticBase>& device, const SkinHeights& skin, double dt_s) noexcept;
  void go(const Eigen::Vector3d& way_m, double dt_s) noexcept;
  void accelerate(const Eigen::Vector3d& way_m, double down_m_per_s, double dt_s) noexcept;

  Way way_ = Way::Follows;
  Point<HapticBase> at_;
  Eigen::Vector3d m_per_s_ = Eigen::Vector3d::Zero();
  bool begun_ = false;
  bool hovered_ = false;  ///< a person points with this hand; false: a headset tracks it
};

}  // namespace telepalp::tracking
