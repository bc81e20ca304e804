#include "tools/replay/figures/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace telepalp::replay {
namespace {

constexpr auto kMetrics = std::to_array<Metric>({
    {"force_rmse_N", "RMS difference between the forces of this run and the unimpaired run", &Figures::force_rmse_N},
    {"force_p99_N", "99th percentile of the difference between the forces of this run and the unimpaired run",
     &Figures::force_p99_N},
    {"force_max_N", "largest force of the device", &Figures::force_max_N},
    {"force_step_N", "largest change of the force from one tick to the next", &Figures::force_step_N},
    {"true_force_rmse_N",
     "RMS difference between the force along the true skin's normal and the force that the true skin would give",
     &Figures::true_force_rmse_N},
    {"true_force_p99_N",
     "99th percentile of the difference between the force along the true skin's normal and the force that the true "
     "skin would give",
     &Figures::true_force_p99_N},
    {"contact_lost_pct",
     "share of ticks without contact, counted over the ticks with the device over 2 mm deep in the true skin (if the "
     "true skin is unknown: over the ticks with contact in the unimpaired run)",
     &Figures::contact_lost_pct},
    {"phase_differs_pct", "share of all ticks in which the controller's phase differs from the unimpaired run's",
     &Figures::phase_differs_pct},
    {"phase_changes", "number of the controller's phase changes", &Figures::phase_changes},
    {"released_pct", "share of all ticks in the phase Released or Faulted", &Figures::released_pct},
    {"surface_error_rms_m", "RMS distance between the displayed and the true surface", &Figures::surface_error_rms_m},
    {"surface_error_p99_m", "99th percentile of the distance between the displayed and the true surface",
     &Figures::surface_error_p99_m},
    {"surface_age_p50_s", "age of the touched surface, median", &Figures::surface_age_p50_s},
    {"surface_age_p99_s", "age of the touched surface, 99th percentile", &Figures::surface_age_p99_s},
    {"energy_J", "lowest energy balance of the display; below 0: the display created energy", &Figures::energy_J},
    {"hand_excess_J", "largest excess work on the hand in one contact: the device's work less the measured skin's",
     &Figures::hand_excess_J},
    {"frames", "number of frames sent, without the last ones, whose deadline (--deadline-ms) is after the run's end",
     &Figures::frames},
    {"frames_in_time_pct", "share of `frames` that are complete by their deadline", &Figures::frames_in_time_pct},
    {"frames_touched_pct", "share of `frames` that became a touchable surface", &Figures::frames_touched_pct},
    {"network_p50_s", "time from encoding to reception, median", &Figures::network_p50_s},
    {"network_p99_s", "time from encoding to reception, 99th percentile", &Figures::network_p99_s},
    {"station_p50_s", "time from reception to touchable surface, median", &Figures::station_p50_s},
    {"total_p50_s", "time from capture to touchable surface, median", &Figures::total_p50_s},
    {"total_p99_s", "time from capture to touchable surface, 99th percentile", &Figures::total_p99_s},
    {"content_B", "size of all encoded frames", &Figures::content_B},
    {"sent_B", "bytes sent by the server, repair packets included", &Figures::sent_B},
    {"answered_B", "bytes that the station sent", &Figures::answered_B},
    {"datagrams_lost", "datagrams of the server that the network lost, except in outages", &Figures::datagrams_lost},
});

std::string number(double value) {
  if (!std::isfinite(value)) return "unknown";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, text.size()), ' ');
}

}  // namespace

std::span<const Metric> metrics() noexcept { return kMetrics; }

const Metric* find_metric(std::string_view name) noexcept {
  const auto found = std::find_if(kMetrics.begin(), kMetrics.end(), [&](const Metric& m) { return m.name == name; });
  return found == kMetrics.end() ? nullptr : &*found;
}

std::string metric_names() {
  std::string names;
  for (const Metric& metric : kMetrics) names += (names.empty() ? "" : ", ") + std::string(metric.name);
  return names;
}

std::string text_table(const Figures& unimpaired, const Figures& figures) {
  std::string text = padded("metric", 22) + padded("unimpaired", 14) + padded("this run", 14) + "meaning\n";
  for (const Metric& metric : kMetrics)
    text += padded(metric.name, 22) + padded(number(unimpaired.*metric.value), 14) +
            padded(number(figures.*metric.value), 14) + std::string(metric.what) + "\n";
  return text;
}

}  // namespace telepalp::replay
