#include "clients/report/figures/compensation_figures.h"

#include "support/plot/palette.h"

namespace telepalp::report {
namespace {

using plot::Chart;
using plot::Series;

/// The value `take(message)` of each message over the time since the session's start [s].
template <class Take>
Series over_time(const Session& session, std::string name, std::string_view color, Take take) {
  Series series{std::move(name), {}, {}, std::string(color)};
  for (const msg::StationCompensation& sample : session.compensations) {
    const auto since_ns = static_cast<std::int64_t>(sample.stamp_ns()) - session.first_ns.value_or(0);
    series.x.push_back(static_cast<double>(since_ns) * 1e-9);
    series.y.push_back(take(sample));
  }
  return series;
}

Chart chart_of(std::string title, std::string unit, std::vector<Series> series) {
  return {.title = std::move(title),
          .x = {"time [s]"},
          .y = {std::move(unit), plot::Range{0.0, 0.0}},
          .series = std::move(series),
          .height_px = 240.0};
}

}  // namespace

std::vector<Chart> compensation(const Session& session) {
  using Sample = const msg::StationCompensation&;
  if (session.compensations.empty()) return {};
  return {
      chart_of("Age of the data behind the force", "age [ms]",
               {over_time(session, "surface", plot::kBlue, [](Sample t) { return t.surface_age_s() * 1e3; }),
                over_time(session, "hand", plot::kVermilion, [](Sample t) { return t.hand_age_s() * 1e3; })}),
      chart_of(
          "The surface, carried forward along its normal", "distance [mm]",
          {over_time(session, "carried forward", plot::kBlue, [](Sample t) { return t.surface_carried_m() * 1e3; }),
           over_time(session, "offset that hides steps between snapshots", plot::kVermilion,
                     [](Sample t) { return t.slewed_m() * 1e3; }),
           over_time(session, "uncertainty, 1 sigma", plot::kGrey,
                     [](Sample t) { return t.surface_sigma_m() * 1e3; })}),
      chart_of(
          "The hand, predicted", "distance [mm]",
          {over_time(session, "carried forward", plot::kVermilion, [](Sample t) { return t.hand_carried_m() * 1e3; }),
           over_time(session, "uncertainty, 1 sigma", plot::kGrey, [](Sample t) { return t.hand_sigma_m() * 1e3; })})};
}

}  // namespace telepalp::report
