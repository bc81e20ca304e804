#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "haptic_station/loop/tick_sample.h"
#include "proto/words/result.h"
#include "tools/study/person/operator.h"
#include "tools/study/task/insertion.h"
#include "tools/study/task/linkage_places.h"

namespace telepalp::study {

/// One instant of a penetration, as the page and the journal need it. It crosses threads by copy.
struct TrialView {
  MechanismPicture picture{};
  Eigen::Vector2d along = -Eigen::Vector2d::UnitY();  ///< direction in which the hand pushes the needle in; unit
  bool through_skin = false;
  double needle_N = 0.0;  ///< force of the needle on the hand
  bool moved = false;     ///< the hand has moved since it took the handle: time runs
  bool over = false;
  double held_up_s = 0.0;  ///< time that the simulation lost, because a program was late
  Outcome outcome;
};
/// `way_m`: distance of the hand from the beginning of its path.
[[nodiscard]] TrialView view_of(const Prepared& prepared, double way_m) noexcept;

/// One tick of a penetration for a session file. Its frame is that of the tissue: x and y in the plane of the linkage,
/// the skin at y = 0. `device` is the hand, `proxy` the tip of the needle, `indentation_m` its depth. Phase, time and
/// number are left to the caller. `shown_N`: the force on the person's hand.
[[nodiscard]] loop::TickSample tick_of(const Prepared& prepared, const Eigen::Vector3d& hand_m,
                                       const Eigen::Vector3d& shown_N) noexcept;

/// One penetration by a person, whatever moves the hand. Owner: the network thread.
class PersonTrial {
 public:
  using Ticks = std::vector<loop::TickSample>;

  virtual ~PersonTrial() = default;
  /// The page moves the hand by `way_m` along the handle's path, or by a motion in the plane z = 0 [m]. A person at a
  /// device moves it there.
  virtual void push(double /*way_m*/) noexcept {}
  virtual void move(const Eigen::Vector2d& /*by_m*/) noexcept {}
  /// `seconds` of real time have passed. Appends the ticks since the last call.
  virtual void step(double seconds, Ticks& ticks) = 0;
  [[nodiscard]] virtual TrialView view() const noexcept = 0;
  /// True: time may run without a message of the page.
  [[nodiscard]] virtual bool moves_by_itself() const noexcept { return false; }
  /// The hand can no longer be followed, as when a device is unplugged.
  [[nodiscard]] virtual std::optional<Error> lost() const { return std::nullopt; }
};

}  // namespace telepalp::study
