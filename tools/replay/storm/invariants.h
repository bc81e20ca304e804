#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tools/replay/cell/cell.h"

namespace telepalp::replay {

/// What must hold at every tick, whatever the network and the faults do:
/// - the force is finite and at most the scene's peak;
/// - in a tick, the force changes by at most 0.05 N more than the effects' stiffness times the device's motion. While
///   the station lets go, this margin is 0.1 N. For 10 ms after a change of contact or phase, only the limiter's slew
///   rate bounds the change;
/// - the energy that the display took from the hand, less the energy stored in its springs, is at least -5 mJ;
/// - in a contact, the device gives the hand little energy that the measured skin would not have given: at most 20 mJ,
///   or 5 % of the work that device and hand exchanged in this contact if this is more;
/// - in a contact, the device takes at most 0.25 J less from the hand than the measured skin would have taken;
/// - when the newest surface has been missing or older than 2.5 s for 0.5 s, the station has released the hand;
/// - from 3 s plus the network's delay after the last injected fault on, a device that stays deeper than 5 mm in the
///   true skin, while the surface is younger than 0.8 s, is without a force of the skin for at most 1.5 s. The time in
///   which the station lifts a device that is deeper than 90 mm, where no contact begins, does not count;
/// - on each topic, publication times do not decrease, and ticks are numbered without a gap.
class Invariants {
 public:
  struct Violation {
    Nanoseconds at{0};  ///< since the session's start
    std::string what;
  };

  /// The worst values of the energy ledgers so far.
  struct Ledgers {
    double least_passivity_J = 0.0;
    double most_excess_J = 0.0;  ///< the largest hand_excess_J that the station reported
    double most_gained_J =
        0.0;  ///< most energy from device to hand in a contact that the measured skin would not have given
    /// Longest time in a contact with less than half of the true skin's force, while this force was above 0.2 N and the
    /// surface younger than 0.5 s.
    double longest_weak_s = 0.0;
  };

  /// `stiffest_N_per_m`: upper bound of the stiffness of the scene's effects together.
  Invariants(const Scenario& scenario, const control::ControlSettings& control, double stiffest_N_per_m);

  /// The next tick, in order.
  void add(const TickRecord& tick);
  /// The next message that the station publishes.
  void add(const wire::Message& message);
  /// The first violation; nullopt: everything held so far.
  [[nodiscard]] const std::optional<Violation>& violation() const noexcept { return violation_; }
  [[nodiscard]] const Ledgers& ledgers() const noexcept { return ledgers_; }

 private:
  void check_force(const TickRecord& tick);
  [[nodiscard]] double most_step_N(const TickRecord& tick) noexcept;
  void check_energy(const TickRecord& tick);
  void check_gain(const TickRecord& tick);
  void note_weak(const TickRecord& tick) noexcept;
  void check_release(const TickRecord& tick);
  void check_felt(const TickRecord& tick);
  void violated(std::string what);
  [[nodiscard]] Nanoseconds now() const noexcept { return kTick * ticks_; }

  control::ControlSettings control_;
  double stiffest_N_per_m_;
  Nanoseconds calm_from_{0};  ///< when the last fault's effects are over; since the session's start
  std::int64_t ticks_ = 0;
  Eigen::Vector3f last_force_N_ = Eigen::Vector3f::Zero();
  Eigen::Vector3d last_device_m_ = Eigen::Vector3d::Zero();
  bool was_touching_ = false;
  control::Phase last_phase_ = control::Phase::Released;
  Nanoseconds unchanged_{std::chrono::hours{1}};  ///< for how long contact and phase have not changed
  Nanoseconds weak_{0};                           ///< time in this contact with less than half of the true skin's force
  double worked_J_ = 0.0;                         ///< work of the device on the hand since the last contact began
  double exchanged_J_ = 0.0;  ///< sum of the magnitudes of each tick's work, since the last contact began
  Nanoseconds stale_{0};      ///< for how long the surface has been missing or older than 2.5 s
  Nanoseconds unfelt_{0};     ///< for how long the device has been deep in the skin without a force of the skin
  std::map<std::string_view, SessionTime> published_;  ///< newest time by topic
  std::uint64_t next_tick_ = 0;
  std::optional<Violation> violation_;
  Ledgers ledgers_;
};

/// "at 3.214 s of the run: the force is not finite (NaN or infinite)".
[[nodiscard]] std::string in_words(const Invariants::Violation& violation);

}  // namespace telepalp::replay
