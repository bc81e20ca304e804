#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tools/replay/cell/cell.h"

namespace telepalp::replay {

/// What must hold at every tick, whatever the network and the faults do:
/// - the force is finite, at most the scene's peak, and changes no faster than the scene's slew rate;
/// - the energy that the display took from the hand, less the energy stored in its springs, is at least -5 mJ;
/// - in a contact, the device gives the hand at most 20 mJ that the measured skin would not have given, and takes at
///   most 0.25 J less from it than the measured skin would have taken;
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
  };

  Invariants(const Scenario& scenario, const control::ControlSettings& control);

  /// The next tick, in order.
  void add(const TickRecord& tick);
  /// The next message that the station publishes.
  void add(const wire::Message& message);
  /// The first violation; nullopt: everything held so far.
  [[nodiscard]] const std::optional<Violation>& violation() const noexcept { return violation_; }
  [[nodiscard]] const Ledgers& ledgers() const noexcept { return ledgers_; }

 private:
  void check_force(const TickRecord& tick);
  void check_energy(const TickRecord& tick);
  void check_gain(const TickRecord& tick);
  void check_release(const TickRecord& tick);
  void check_felt(const TickRecord& tick);
  void violated(std::string what);
  [[nodiscard]] Nanoseconds now() const noexcept { return kTick * ticks_; }

  control::ControlSettings control_;
  Nanoseconds calm_from_{0};  ///< when the last fault's effects are over; since the session's start
  std::int64_t ticks_ = 0;
  Eigen::Vector3f last_force_N_ = Eigen::Vector3f::Zero();
  Eigen::Vector3d last_device_m_ = Eigen::Vector3d::Zero();
  bool was_touching_ = false;
  double worked_J_ = 0.0;  ///< by the device on the hand since the last contact began
  Nanoseconds stale_{0};   ///< for how long the surface has been missing or older than 2.5 s
  Nanoseconds unfelt_{0};  ///< for how long the device has been deep in the skin without a force of the skin
  std::map<std::string_view, SessionTime> published_;  ///< newest time by topic
  std::uint64_t next_tick_ = 0;
  std::optional<Violation> violation_;
  Ledgers ledgers_;
};

/// "at 3.214 s of the run: the force is not finite (NaN or infinite)".
[[nodiscard]] std::string in_words(const Invariants::Violation& violation);

}  // namespace telepalp::replay
