#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptic_station/core/outbox/run_totals.h"
#include "haptic_station/loop/compensation.h"
#include "haptic_station/loop/tick_sample.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/message.h"
#include "proto/words/frames.h"
#include "proto/words/time.h"

namespace telepalp::core {

/// Everything that a station publishes, as messages: values in, messages out, in the order in which they are sent. The
/// station, a replay and the bill of a scene make their messages here, so equal values give equal bytes. `now`: the
/// session time of publication. Owner: one thread.
class Outbox {
 public:
  using Messages = std::vector<wire::Message>;

  /// Facts about the station and its computer that its messages repeat.
  struct Facts {
    /// Bound on the error of the session clock, in all messages that hold ages; infinite: the clock is not known.
    double clock_error_s = std::numeric_limits<double>::infinity();
    bool realtime = false;                        ///< real-time priority and locked memory were granted
    std::string software{};                       ///< name, version and commit
    std::optional<msg::TimerCheck> idle_timer{};  ///< wake-up latency of an otherwise idle thread on this computer
    std::optional<msg::RigidMotion> haptic_from_tracker{};  ///< the calibration in use
    std::vector<msg::EffectCost> costs{};                   ///< computing time of each effect
  };
  /// Counts since the station's start.
  struct Counts {
    std::uint64_t deadlines_missed = 0;
    std::uint64_t ticks_dropped = 0;   ///< not in any message, because the network thread was too slow
    std::uint64_t frames_dropped = 0;  ///< depth images that gave no surface
  };
  /// A batch holds at most a tenth of a second, so that a viewer that plots ticks gets them promptly after a pause.
  static constexpr std::size_t kMostInBatch = 200;

  /// The messages of ticks in their order, at most kMostInBatch: an event at each phase change, all ticks in a message
  /// for each unbroken run, the state at the first tick of each 10 ms of session time, and a warning 4 s before the
  /// warm motors can no longer hold the contact force. The warning is repeated only in a later contact, or after the
  /// force has once been low enough for the motors to hold it without a time limit.
  [[nodiscard]] Messages ticks(std::span<const loop::TickSample> batch, SessionTime now);

  [[nodiscard]] wire::Message compensation(const loop::Compensation& compensation, SessionTime now) const;
  [[nodiscard]] wire::Message surface(msg::SurfaceReport report, SessionTime now) const;
  [[nodiscard]] wire::Message event(msg::EventKind kind, const std::string& text, SessionTime now) const;
  /// `first`: the first tick in the phase Faulted.
  [[nodiscard]] static wire::Message fault(const loop::TickSample& first, SessionTime now);
  [[nodiscard]] static wire::Message ultrasound(const msg::UltrasoundImage& image, SessionTime now);
  [[nodiscard]] static wire::Message inside(const msg::InnerStructures& structures, SessionTime now);
  /// The run's totals so far.
  [[nodiscard]] wire::Message totals(const Counts& counts, SessionTime now) const;

  void frame_received() noexcept { totals_.frame_received(); }
  [[nodiscard]] Facts& facts() noexcept { return facts_; }
  /// The newest tick of ticks(); nullopt before the first one.
  [[nodiscard]] const std::optional<loop::TickSample>& last() const noexcept { return last_; }

 private:
  [[nodiscard]] bool begins_state_period(const loop::TickSample& tick) noexcept;
  [[nodiscard]] bool heat_is_near(const loop::TickSample& tick) noexcept;

  Facts facts_;
  RunTotals totals_;
  std::optional<loop::TickSample> last_;
  std::int64_t state_period_ = -1;  // number of the last published state's 10 ms period since session time 0
  bool heat_warned_ = false;
};

/// A calibration as messages state it.
[[nodiscard]] msg::RigidMotion motion_message(const Transform<HapticBase, HandTracker>& haptic_from_tracker);

}  // namespace telepalp::core
