#include "clients/report/figures/energy_figures.h"

#include <algorithm>
#include <cmath>

#include "clients/report/summary/quantiles.h"
#include "support/plot/palette.h"

namespace telepalp::report {
namespace {

using plot::Chart;
using plot::Series;

/// `take` of every message, against seconds since the session began; infinite values are gaps.
template <class Messages, class Take>
Series over_time(const Session& session, const Messages& messages, std::string name, std::string_view color,
                 Take take) {
  Series series{std::move(name), {}, {}, std::string(color)};
  for (const auto& message : messages) {
    const auto since_ns = static_cast<std::int64_t>(message.stamp_ns()) - session.first_ns.value_or(0);
    const double value = take(message);
    series.x.push_back(static_cast<double>(since_ns) * 1e-9);
    series.y.push_back(std::isfinite(value) ? value : kUnknown);
  }
  return series;
}

}  // namespace

std::vector<Chart> energy(const Session& session) {
  if (session.states.empty()) return {};
  using State = const msg::StationState&;
  using Message = const msg::StationCompensation&;
  return {{.title = "Energy of the contact",
           .x = {"time [s]"},
           .y = {"energy [mJ]", plot::Range{0.0, 0.0}},
           .series = {over_time(session, session.states, "energy balance of the display", plot::kBlue,
                                [](State s) { return s.passivity_j() * 1e3; }),
                      over_time(session, session.states, "excess work on the hand, beyond that of the measured skin",
                                plot::kVermilion, [](State s) { return s.hand_excess_j() * 1e3; }),
                      over_time(session, session.compensations, "work of moving the device (lift, position control)",
                                plot::kGrey, [](Message m) { return m.drive_j() * 1e3; })},
           .height_px = 240.0}};
}

std::vector<Chart> heat(const Session& session) {
  using State = const msg::StationState&;
  // A station sends 0 when it does not know its motors' heat, and when the force is lowered already.
  const auto left_s = [](State s) { return s.yields_in_s() > 0.0 ? s.yields_in_s() : kUnknown; };
  if (std::none_of(session.states.begin(), session.states.end(), [&](State s) { return std::isfinite(left_s(s)); }))
    return {};
  return {{.title = "Time until warm motors lower the force",
           .x = {"time [s]"},
           .y = {"time left [s]", plot::Range{0.0, 5.0}},
           .series = {over_time(session, session.states, "", plot::kVermilion, left_s)},
           .height_px = 200.0}};
}

}  // namespace telepalp::report
