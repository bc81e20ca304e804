#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clients/report/session/session.h"

namespace telepalp::report {

/// A measurement that a session holds many times, each with its time.
enum class Measurement {
  None,
  Force,       ///< at each tick: norm of the force [N]
  NotFinite,   ///< at each tick: how many of its numbers are not finite
  Fault,       ///< at each tick: 1 if it entered the phase Faulted, else 0
  TickTime,    ///< of each tick: computing time [µs]
  TickEnd,     ///< of each tick: its end after its deadline [µs]
  Latency,     ///< of each depth image that became touchable: from its capture until then [ms]
  ClockError,  ///< at each of these images: error bound of the station's clock [ms]
  Balance,     ///< at each state: energy balance of the display [mJ]
  ExcessWork,  ///< at each state: excess work on the hand [mJ]
};

/// The samples of a measurement that passed a limit. Times are seconds since the session's first message.
struct Moments {
  std::size_t passed = 0;
  std::size_t samples = 0;
  double first_s = 0.0, last_s = 0.0;  ///< of the first and the last of them
  std::size_t in_contact = 0;          ///< of them, during a contact
  std::size_t phase_unknown = 0;       ///< of them, at a time without ticks
  double worst = 0.0, worst_s = 0.0;
  std::optional<msg::Phase> worst_phase;
};

/// `at_most`: true: samples above `limit` count; false: samples below it.
[[nodiscard]] Moments moments_beyond(const Session& session, Measurement measurement, double limit, bool at_most);

/// "14 of 1043 depth images, from 3.21 s to 3.72 s, none of them in contact. The worst: 917 ms at 3.41 s (Above the
/// skin)". Empty: no sample passed the limit.
[[nodiscard]] std::string in_words(const Moments& moments, Measurement measurement);

}  // namespace telepalp::report
