#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/quantiles.h"

namespace telepalp::report {

/// How long and how often the station was in one state.
struct Dwell {
  std::uint64_t entries = 0;
  double seconds = 0.0;
};

/// What one sender on the topics of a station did, to tell several apart.
struct SenderSummary {
  std::uint32_t sender = 0;
  std::string name, address;  ///< as the server knew them; empty when the session does not tell
  std::uint64_t messages = 0, ticks = 0, states = 0, touches = 0;
  double force_max_N = kUnknown;
  std::optional<std::uint64_t> frames_sent, frames_received, frames_dropped;
};

/// The timer of the station's computer while the station only waited, before the run.
struct IdleTimer {
  std::uint64_t wakeups = 0, missed = 0;
  [[nodiscard]] double missed_share() const noexcept {
    return wakeups > 0 ? static_cast<double>(missed) / static_cast<double>(wakeups) : 0.0;
  }
};

/// The figures of a run. kUnknown where the session does not hold what a figure needs.
struct Summary {
  double seconds = 0.0;
  std::uint64_t ticks = 0;
  Quantiles tick_us;
  Quantiles lateness_us;
  std::optional<std::uint64_t> deadlines_missed;
  std::optional<std::uint64_t> telemetry_dropped;
  std::optional<bool> realtime;
  std::optional<IdleTimer> idle_timer;
  std::vector<SenderSummary> senders;  ///< on the topics of a station; the first is the one that the rest tells of

  std::optional<std::uint64_t> frames_sent;      ///< depth frames that the hub sent to the station
  std::optional<std::uint64_t> frames_received;  ///< by the station
  std::optional<std::uint64_t> frames_dropped;   ///< at the hub, overtaken on the way to the station

  double camera_depth_per_s = kUnknown;
  double camera_color_per_s = kUnknown;
  double ticks_per_s = kUnknown;
  double states_per_s = kUnknown;

  Quantiles capture_to_encoded_ms, encoded_to_received_ms, received_to_decoded_ms, decoded_to_touchable_ms;
  Quantiles capture_to_touchable_ms;
  Quantiles surface_carried_mm, hand_carried_mm;  ///< over the delay, by prediction; without their sign
  /// How the depth under the hand was compressed, the least exact of it; that of the images where no station tells.
  wire::DepthFidelity depth;
  Quantiles surface_age_ms;  ///< of the surface that the force came from

  std::vector<Dwell> dwells;  ///< in the order of kPhases
  std::uint64_t touches = 0;  ///< times that contact began
  double contact_s = 0.0;
  double force_max_N = kUnknown;  ///< in any state; out of the body it moves the free device
  double force_in_contact_max_N = kUnknown;
  double indentation_max_mm = kUnknown;
  std::uint64_t non_finite = 0;  ///< forces, positions or depths that are no numbers
  std::uint64_t damaged_messages = 0;
  std::vector<msg::EffectCost> bill;
};

[[nodiscard]] Summary summarise(const Session& session);

/// Norm of the force at each tick [N].
[[nodiscard]] std::vector<double> force_norm_N(const Ticks& ticks);

}  // namespace telepalp::report
