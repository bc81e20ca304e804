#include "clients/report/summary/moments.h"

#include <algorithm>
#include <cmath>

#include "clients/ar/messages/phases.h"
#include "clients/report/summary/summary.h"
#include "proto/wire/station/contact_force.h"
#include "proto/words/counted.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

/// Phase of the tick at or before `at_ns`; nullopt if the session has no tick within 0.1 s before.
std::optional<msg::Phase> phase_at(const Ticks& ticks, std::int64_t at_ns) {
  constexpr std::int64_t kReach_ns = 100'000'000;
  const auto after = std::upper_bound(ticks.at_ns.begin(), ticks.at_ns.end(), at_ns);
  if (after == ticks.at_ns.begin()) return std::nullopt;
  const auto place = static_cast<std::size_t>(after - ticks.at_ns.begin()) - 1;
  if (at_ns - ticks.at_ns[place] > kReach_ns) return std::nullopt;
  return ticks.phase[place];
}

/// Calls `take(time, value, phase)` for every sample of a measurement.
template <class Take>
class Samples {
 public:
  Samples(const Session& session, Take take) : session_(session), take_(std::move(take)) {}

  void go_through(Measurement measurement) {
    switch (measurement) {
      case Measurement::None:
        return;
      case Measurement::Force:
        return of_ticks([norms = force_norm_N(session_.ticks)](const Ticks&, std::size_t i) { return norms[i]; });
      case Measurement::NotFinite:
        return of_ticks([](const Ticks& t, std::size_t i) { return not_finite(t, i); });
      case Measurement::Fault:
        return of_ticks([](const Ticks& t, std::size_t i) {
          return t.phase[i] == msg::PHASE_FAULTED && (i == 0 || t.phase[i - 1] != msg::PHASE_FAULTED) ? 1.0 : 0.0;
        });
      case Measurement::TickTime:
        return of_ticks([](const Ticks& t, std::size_t i) { return double{t.work_us[i]}; });
      case Measurement::TickEnd:
        return of_ticks([](const Ticks& t, std::size_t i) { return double{t.late_us[i]} + double{t.work_us[i]}; });
      case Measurement::Latency:
        return of_surfaces([](const msg::SurfaceReport& s) {
          return 1e-6 * static_cast<double>(static_cast<std::int64_t>(s.touchable_ns() - s.captured_ns()));
        });
      case Measurement::ClockError:
        return of_surfaces([](const msg::SurfaceReport& s) { return 1e3 * s.clock_error_s(); });
      case Measurement::Balance:
        return of_states([](const msg::StationState& s) { return 1e3 * s.passivity_j(); });
      case Measurement::ExcessWork:
        return of_states([](const msg::StationState& s) { return 1e3 * s.hand_excess_j(); });
    }
  }

 private:
  static double not_finite(const Ticks& ticks, std::size_t i) {
    int count = 0;
    for (const Axes* axes : {&ticks.hand, &ticks.device, &ticks.proxy, &ticks.force})
      for (const std::vector<float>& column : *axes) count += std::isfinite(column[i]) ? 0 : 1;
    for (const std::vector<float>* column : {&ticks.indentation_m, &ticks.distance_m})
      count += std::isfinite((*column)[i]) ? 0 : 1;
    return count;
  }
  template <class Value>
  void of_ticks(Value value) {
    for (std::size_t i = 0; i < session_.ticks.size(); ++i)
      take_(session_.ticks.at_ns[i], value(session_.ticks, i), std::optional(session_.ticks.phase[i]));
  }
  template <class Value>
  void of_surfaces(Value value) {
    for (const msg::SurfaceReport& surface : session_.surfaces) {
      if (surface.captured_ns() == 0 || surface.touchable_ns() == 0) continue;  // 0: this stage was not stamped
      const auto at_ns = static_cast<std::int64_t>(surface.touchable_ns());
      take_(at_ns, value(surface), phase_at(session_.ticks, at_ns));
    }
  }
  template <class Value>
  void of_states(Value value) {
    for (const msg::StationState& state : session_.states)
      take_(static_cast<std::int64_t>(state.stamp_ns()), value(state), std::optional(state.phase()));
  }

  const Session& session_;
  Take take_;
};

struct Nouns {
  const char* one;
  const char* more;
  const char* unit;  ///< empty: the worst sample is not named
};

Nouns nouns_of(Measurement measurement) {
  switch (measurement) {
    case Measurement::Force:
      return {"tick", "ticks", "N"};
    case Measurement::NotFinite:
    case Measurement::Fault:
    case Measurement::None:
      return {"tick", "ticks", ""};
    case Measurement::TickTime:
    case Measurement::TickEnd:
      return {"tick", "ticks", "µs"};
    case Measurement::Latency:
    case Measurement::ClockError:
      return {"depth image", "depth images", "ms"};
    case Measurement::Balance:
    case Measurement::ExcessWork:
      return {"state", "states", "mJ"};
  }
  return {"", "", ""};
}

std::string seconds_text(double at_s) { return plot::number(at_s, 2) + " s"; }

std::string contact_words(const Moments& moments) {
  if (moments.phase_unknown == moments.passed) return "";
  if (moments.passed == 1) return moments.in_contact == 1 ? ", in contact" : ", not in contact";
  if (moments.in_contact == 0) return ", none of them in contact";
  if (moments.in_contact == moments.passed) return ", all of them in contact";
  return ", " + std::to_string(moments.in_contact) + " of them in contact";
}

}  // namespace

Moments moments_beyond(const Session& session, Measurement measurement, double limit, bool at_most) {
  Moments found;
  const auto take = [&](std::int64_t at_ns, double value, const std::optional<msg::Phase>& phase) {
    ++found.samples;
    if (!(at_most ? value > limit : value < limit)) return;
    const double at_s = to_seconds(Nanoseconds(at_ns - session.first_ns.value_or(0)));
    if (found.passed == 0) found.first_s = at_s;
    found.last_s = at_s;
    if (found.passed == 0 || (at_most ? value > found.worst : value < found.worst)) {
      found.worst = value;
      found.worst_s = at_s;
      found.worst_phase = phase;
    }
    ++found.passed;
    found.in_contact += phase && wire::is_contact(*phase) ? 1 : 0;
    found.phase_unknown += phase ? 0 : 1;
  };
  Samples(session, take).go_through(measurement);
  return found;
}

std::string in_words(const Moments& moments, Measurement measurement) {
  if (moments.passed == 0) return "";
  const Nouns nouns = nouns_of(measurement);
  std::string text = moments.passed == moments.samples
                         ? "all " + counted(moments.passed, nouns.one, nouns.more)
                         : std::to_string(moments.passed) + " of " + counted(moments.samples, nouns.one, nouns.more);
  text += moments.passed == 1 ? ", at " + seconds_text(moments.first_s)
                              : ", from " + seconds_text(moments.first_s) + " to " + seconds_text(moments.last_s);
  text += contact_words(moments);
  if (*nouns.unit == '\0') return text;
  text += ". The worst: " + plot::readable(moments.worst) + " " + nouns.unit + " at " + seconds_text(moments.worst_s);
  if (moments.worst_phase) text += " (" + std::string(ar::words_for(*moments.worst_phase).words) + ")";
  return text;
}

}  // namespace telepalp::report
