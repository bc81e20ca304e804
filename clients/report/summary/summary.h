#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/quantiles.h"

namespace telepalp::report {

/// Total duration of one state of the controller, and how often it was entered.
struct Dwell {
  std::uint64_t entries = 0;
  double seconds = 0.0;
};

/// Totals of one sender on the station's topics; a session may have several senders.
struct SenderSummary {
  std::uint32_t sender = 0;
  std::string name, address;  ///< from the server's statistics; empty: not in the session
  std::uint64_t messages = 0, ticks = 0, states = 0, touches = 0;
  double force_max_N = kUnknown;
  std::optional<std::uint64_t> frames_sent, frames_received, frames_dropped;
  std::optional<std::uint64_t> frames_unused;  ///< of those received: replaced by a newer one, or not decodable
  std::int64_t sent_until_ns = 0, received_until_ns = 0;  ///< session times of the last counts
  std::vector<Carrier> carriers;                          ///< of its images
  SharedLine shared_line;                                 ///< of its connections
};

/// Wake-ups of a thread that only waits, measured on the station's computer before the run.
struct IdleTimer {
  std::uint64_t wakeups = 0, missed = 0;  ///< missed: wake-ups that came after the next one was due
  [[nodiscard]] double missed_share() const noexcept {
    return wakeups > 0 ? static_cast<double>(missed) / static_cast<double>(wakeups) : 0.0;
  }
};

/// The way that images and touch took between server and station, as the station told it.
struct Way {
  double from_s = 0.0;  ///< since the session's beginning
  std::string words;    ///< "by datagrams over a relay (UDP), round trip 43 ms"
};

/// The results of a run. A value is NaN (kUnknown) when the session lacks the messages for it.
struct Summary {
  double seconds = 0.0;
  std::uint64_t ticks = 0;
  Quantiles tick_us;
  Quantiles lateness_us;
  std::optional<std::uint64_t> deadlines_missed;
  std::optional<std::uint64_t> telemetry_dropped;
  std::optional<bool> realtime;
  std::optional<IdleTimer> idle_timer;
  std::vector<SenderSummary> senders;  ///< senders on the station's topics; the other members describe the first

  std::optional<std::uint64_t> frames_sent;      ///< depth frames that the hub sent to the station
  std::optional<std::uint64_t> frames_received;  ///< depth frames that the station received
  std::optional<std::uint64_t> frames_dropped;   ///< depth frames for the station that the hub dropped
  std::optional<std::uint64_t> frames_unused;    ///< of the received ones: replaced by a newer one, or not decodable
  /// Estimate of the sent frames that were still on the way when the station last counted; 0 if it is not known.
  std::uint64_t frames_on_the_way = 0;
  std::vector<Carrier> carriers;  ///< of the station's images
  SharedLine shared_line;         ///< of its connections
  std::vector<Way> ways;          ///< in the order of time; empty: the session does not tell

  std::optional<std::uint64_t> depth_images;  ///< in the file
  std::optional<std::uint64_t> surfaces;      ///< depth images that became a surface

  /// Received frames of those that were sent and not on the way any more, 0 to 1; NaN (kUnknown) if a count is unknown
  /// or none was sent.
  [[nodiscard]] double received_share() const noexcept {
    if (!frames_sent || !frames_received || *frames_sent <= frames_on_the_way) return kUnknown;
    return static_cast<double>(*frames_received) / static_cast<double>(*frames_sent - frames_on_the_way);
  }

  double camera_depth_per_s = kUnknown;
  double camera_color_per_s = kUnknown;
  double ticks_per_s = kUnknown;               ///< that the station made, by their numbers
  std::optional<std::uint64_t> ticks_missing;  ///< ticks between the first and the last that the file lacks
  double states_per_s = kUnknown;

  Quantiles capture_to_encoded_ms, encoded_to_received_ms, received_to_decoded_ms, decoded_to_touchable_ms;
  Quantiles capture_to_touchable_ms;
  double object_unseen_share = 0.0;        ///< share of time: an inner object stands still: the skin above it is unseen
  double object_slide_unseen_share = 0.0;  ///< share of time: an inner object cannot follow the skin's tangential slide
  double unmodelled_share = 0.0;           ///< share of time: prediction reduced after an unusual motion of the patient
  Quantiles surface_carried_mm, hand_carried_mm;  ///< magnitude of the predicted displacement
  /// The loosest bound of the depth that the station touched; without a station, that of the recorded images.
  wire::DepthFidelity depth;
  Quantiles surface_age_ms;  ///< age of the surface from which the force was computed
  Quantiles assumed_age_ms;  ///< age by which the station predicted the surface: by its own clock
  /// Bound on the error of every latency and age that compares the server's clock with the station's.
  Quantiles clock_error_ms;

  std::vector<Dwell> dwells;  ///< in the order of ar::kPhases
  std::uint64_t touches = 0;  ///< number of contacts
  double contact_s = 0.0;
  double force_max_N = kUnknown;  ///< largest in any state
  double force_in_contact_max_N = kUnknown;
  double force_of_drive_max_N = kUnknown;  ///< largest out of contact: no part of it comes from the patient
  double indentation_max_mm = kUnknown;
  double display_least_mJ = kUnknown;     ///< least balance, energy from the hand minus stored; < 0: energy was created
  double hand_excess_most_mJ = kUnknown;  ///< largest in a contact: work on the hand minus the measured skin's work
  std::uint64_t heat_warnings = 0;        ///< announcements that warm motors will lower the force
  std::uint64_t non_finite = 0;           ///< forces, positions, indentations and distances that are not finite
  std::uint64_t damaged_messages = 0;
  std::vector<msg::EffectCost> bill;  ///< computing time per tick of each haptic effect
};

[[nodiscard]] Summary summarise(const Session& session);

/// Norm of the force at each tick [N].
[[nodiscard]] std::vector<double> force_norm_N(const Ticks& ticks);

}  // namespace telepalp::report
