#include "clients/report/figures/compensation_figures.h"

#include <algorithm>
#include <cmath>

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
          .y = {std::move(unit), plot::Range{0.0, 1.0}},  // a micrometre of noise must not fill the chart
          .series = std::move(series),
          .height_px = 240.0};
}

/// A chart of which the y axis has words instead of numbers: `words[i]` stands at the value i.
Chart chart_of_words(std::string title, std::vector<std::string> words, Series series) {
  Chart chart{.title = std::move(title),
              .x = {"time [s]"},
              .y = {.label = "", .include = plot::Range{0.0, static_cast<double>(words.size()) - 1.0}},
              .series = {std::move(series)},
              .height_px = 130.0};
  for (std::size_t i = 0; i < words.size(); ++i) chart.y.ticks.push_back({static_cast<double>(i), std::move(words[i])});
  return chart;
}

/// `take` of the object with the number `at` of every message; 0 where the message has no such object.
template <class Take>
Series over_object(const Session& session, int at, std::string name, std::string_view color, Take take) {
  return over_time(session, std::move(name), color, [at, take](const msg::StationCompensation& message) {
    return at < message.objects_size() ? take(message.objects(at)) : 0.0;
  });
}

/// Two charts for each object inside the body: how far it has moved with the skin, and what is seen of the skin.
void add_objects(const Session& session, std::vector<Chart>& charts) {
  using Object = const msg::ObjectPlacement&;
  const msg::StationCompensation& last = session.compensations.back();
  for (int at = 0; at < last.objects_size(); ++at) {
    const std::string name = "The " + last.objects(at).name() + " inside the body";
    charts.push_back(
        chart_of(name + ", following the skin", "distance [mm]",
                 {over_object(session, at, "moved up", plot::kBlue, [](Object o) { return o.moved().y() * 1e3; }),
                  over_object(session, at, "moved sideways", plot::kVermilion,
                              [](Object o) { return std::hypot(o.moved().x(), o.moved().z()) * 1e3; }),
                  over_object(session, at, "uncertainty of the place along the skin, 1 sigma", plot::kGrey,
                              [](Object o) { return o.sigma_slide_m() * 1e3; })}));
    charts.push_back(chart_of_words(name + ": how it follows the skin above it",
                                    {"not: skin not seen", "up and down only", "in every direction"},
                                    over_object(session, at, "", plot::kBlack, [](Object o) {
                                      return o.unseen() ? 0.0 : o.slide_unseen() ? 1.0 : 2.0;
                                    })));
  }
}

}  // namespace

std::vector<Chart> compensation(const Session& session) {
  using Sample = const msg::StationCompensation&;
  if (session.compensations.empty()) return {};
  std::vector<Chart> charts{
      chart_of("Age of the data from which the force is computed", "age [ms]",
               {over_time(session, "surface", plot::kBlue, [](Sample t) { return t.surface_age_s() * 1e3; }),
                over_time(session, "hand", plot::kVermilion, [](Sample t) { return t.hand_age_s() * 1e3; }),
                over_time(session, "largest error of the surface's age (from estimating the server's clock)",
                          plot::kGrey, [](Sample t) { return t.clock_error_s() * 1e3; })}),
      chart_of(
          "Predicted motion of the surface along its normal", "distance [mm]",
          {over_time(session, "predicted motion", plot::kBlue, [](Sample t) { return t.surface_carried_m() * 1e3; }),
           over_time(session, "displayed minus measured surface (gradual change)", plot::kVermilion,
                     [](Sample t) { return t.slewed_m() * 1e3; }),
           over_time(session, "uncertainty, 1 sigma", plot::kGrey,
                     [](Sample t) { return t.surface_sigma_m() * 1e3; })}),
      chart_of(
          "Predicted motion of the hand", "distance [mm]",
          {over_time(session, "predicted motion", plot::kVermilion, [](Sample t) { return t.hand_carried_m() * 1e3; }),
           over_time(session, "uncertainty, 1 sigma", plot::kGrey, [](Sample t) { return t.hand_sigma_m() * 1e3; })})};
  if (std::any_of(session.compensations.begin(), session.compensations.end(),
                  [](Sample t) { return t.unmodelled() > 0.5; }))
    charts.push_back(chart_of_words("The patient's motion, compared with the seconds before",
                                    {"as before", "unlike before"},
                                    over_time(session, "", plot::kBlue, [](Sample t) { return t.unmodelled(); })));
  if (std::any_of(session.compensations.begin(), session.compensations.end(),
                  [](Sample t) { return t.has_loop_delay_s(); }))
    charts.push_back(chart_of("Delay of the device's own loop: its reading's age plus its command's age", "delay [ms]",
                              {over_time(session, "99th percentile of the last second", plot::kBlue,
                                         [](Sample t) { return t.loop_delay_s() * 1e3; })}));
  add_objects(session, charts);
  return charts;
}

}  // namespace telepalp::report
