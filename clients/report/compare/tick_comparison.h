#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "clients/report/session/session.h"
#include "clients/report/summary/quantiles.h"

namespace telepalp::report {

/// The session times at which the common time axis of two runs begins.
struct Origins {
  std::int64_t a_ns = 0;
  std::int64_t b_ns = 0;
};

/// True if the two sessions share an interval of session time: two replays of one source, or two recordings of one
/// run.
[[nodiscard]] bool share_time(const Session& a, const Session& b) noexcept;

/// If the sessions share time, the earlier of their first messages, for both; otherwise the first tick of each, or its
/// first message if it has no tick.
[[nodiscard]] Origins common_origins(const Session& a, const Session& b) noexcept;

/// Index of the tick of `ticks` that is nearest to `at_ns`, searched from `from` on. `ticks` is not empty, and its
/// times ascend.
[[nodiscard]] std::size_t nearest_tick(const Ticks& ticks, std::int64_t at_ns, std::size_t from) noexcept;

/// Both runs at an equal time since their origins.
struct Instant {
  double at_s = 0.0;           ///< time since the origins
  std::size_t tick_a = 0;      ///< index in the ticks of the first run
  std::size_t tick_b = 0;      ///< index in the ticks of the second run
  double force_apart_N = 0.0;  ///< length of the difference of the force vectors
  double hands_apart_m = 0.0;  ///< distance between the tracked hands
};

/// Ticks of one run that the other run lacks.
struct MissingTicks {
  std::size_t count = 0;
  double from_s = 0.0;   ///< begin of the longest gap, since the origins
  double until_s = 0.0;  ///< its end
};

/// Two runs, tick by tick. Without common ticks, `common` is 0 and the other members are empty or 0.
struct TickComparison {
  std::size_t common = 0;              ///< ticks of the first run with a tick of the second within half a period
  double force_rms_N = 0.0;            ///< of the force difference, over the common ticks with finite forces
  std::size_t phase_other = 0;         ///< common ticks at which the phases differ
  std::optional<Instant> first_phase;  ///< the first tick at which the phases differ
  /// The first tick with contact in at least one run at which the forces differ by more than kFelt_N. Out of contact,
  /// the force moves the free device and is not felt.
  std::optional<Instant> first_felt;
  std::optional<Instant> largest;   ///< the tick of the largest force difference; nullopt: the forces are equal
  double contact_rms_N = kUnknown;  ///< of the force difference, over the common ticks with contact in at least one run
  double contact_p99_N = kUnknown;  ///< 99th percentile of the force difference over the same ticks
  std::size_t contact = 0;          ///< common ticks with contact in at least one run
  std::size_t one_sided = 0;        ///< of these: with contact in one run only
  MissingTicks missing_in_a, missing_in_b;
  std::vector<double> at_s;     ///< time since the origins of each common tick
  std::vector<double> apart_N;  ///< force difference at each common tick
};

/// A difference of force that a hand can notice in a small contact force: a tenth of 0.5 N.
inline constexpr double kFelt_N = 0.05;

[[nodiscard]] TickComparison compare_ticks(const Session& a, const Session& b);

}  // namespace telepalp::report
