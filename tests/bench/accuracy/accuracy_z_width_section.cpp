#include <cmath>

#include "haptic_station/control/safety/virtual_coupling.h"
#include "haptic_station/trials/z_width.h"
#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "tests/bench/accuracy/accuracy_sections.h"

namespace telepalp::bench {
namespace {

constexpr double kRates_hz[] = {250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0};
constexpr double kDampings[] = {0.25, 0.5, 1.0, 2.0, 4.0};  // [N s/m]
constexpr std::string_view kColors[] = {plot::kSky, plot::kBlue, plot::kGreen, plot::kOrange, plot::kVermilion};
constexpr double kUsualDamping = 1.0;

constexpr double kStationRate_hz = 2000.0;
constexpr double kDelays_s[] = {0.0, 0.0005, 0.001, 0.002, 0.004};
constexpr double kEncoders_m[] = {0.13e-6, 5e-6, 20e-6, 55e-6, 100e-6};

std::string damping_name(double damping) { return cell(damping) + " N s/m"; }

/// A table of the stiffest stable wall, by the device's loop delay and its encoder's step, beside the limit of the
/// stiffness that the station sets at this delay.
void add_delays(Section& section) {
  PageTable table{.head = {"loop delay, ms"}, .rows = {}};
  for (const double step_m : kEncoders_m) table.head.push_back(cell(1e6 * step_m) + " um");
  table.head.push_back("b / (T/2 + delay)");
  table.head.push_back("the station's limit");
  for (const double delay_s : kDelays_s) {
    const double theory = kUsualDamping / (0.5 / kStationRate_hz + delay_s);
    table.rows.push_back({cell(1e3 * delay_s)});
    for (const double step_m : kEncoders_m) {
      const double shown = trials::largest_stable_stiffness_N_per_m(
          kStationRate_hz, {.damping_N_s_per_m = kUsualDamping, .encoder_step_m = step_m}, delay_s);
      table.rows.back().push_back(cell(shown));
      section.rows.push_back(measured("Z-width at a loop delay of " + cell(1e3 * delay_s) + " ms, encoders of " +
                                          cell(1e6 * step_m) +
                                          " um: stiffest wall at rest, divided by b / (T/2 + delay)",
                                      shown / theory, ""));
    }
    table.rows.back().push_back(cell(theory));
    table.rows.back().push_back(cell(control::stiffest_shown_N_per_m({.loop_delay_s = delay_s})));
  }
  section.parts.push_back({"z-width-delay", to_markdown(table)});
}

}  // namespace

Result<Section> z_width_section() {
  Section section;
  PageTable table{.head = {"damping, N s/m"}, .rows = {}};
  for (const double rate_hz : kRates_hz) table.head.push_back(cell(rate_hz) + " Hz");
  plot::Chart chart{.title =
                        "the stiffest wall that comes to rest: measured (dots), theory 2 b / T (lines); b: damping, T: "
                        "sampling period",
                    .x = {.label = "sampling rate [Hz]", .logarithmic = true},
                    .y = {.label = "stiffness [N/m]", .logarithmic = true}};
  chart.height_px = 420.0;
  for (const double rate_hz : kRates_hz) chart.x.ticks.push_back({rate_hz, cell(rate_hz)});
  for (std::size_t i = 0; i < std::size(kDampings); ++i) {
    const double damping = kDampings[i];
    const std::string color(kColors[i]);
    plot::Series measured_dots{"", {}, {}, color, plot::Style::Dots};
    plot::Series theory{damping_name(damping), {}, {}, color, plot::Style::Line};
    table.rows.push_back({cell(damping)});
    for (const double rate_hz : kRates_hz) {
      const double shown = trials::largest_stable_stiffness_N_per_m(rate_hz, damping);
      const double limit = 2.0 * damping * rate_hz;
      measured_dots.x.push_back(rate_hz);
      measured_dots.y.push_back(shown);
      theory.x.push_back(rate_hz);
      theory.y.push_back(limit);
      table.rows.back().push_back(cell(shown));
      section.rows.push_back(
          measured("Z-width at " + cell(rate_hz) + " Hz, " + damping_name(damping) +
                       ": stiffest wall at rest, divided by 2 b / T (b: damping, T: sampling period)",
                   shown / limit, ""));
    }
    chart.series.push_back(std::move(theory));
    chart.series.push_back(std::move(measured_dots));
  }
  const double coupled = control::stiffest_shown_N_per_m({.device_damping_N_s_per_m = kUsualDamping});
  chart.rules.push_back(
      {coupled, "stiffer scenes are coupled, " + damping_name(kUsualDamping) + " at 2 kHz", std::string(plot::kGrey)});
  section.rows.push_back(
      measured("stiffest scene without virtual coupling, " + damping_name(kUsualDamping), coupled, "N/m"));
  section.parts = {{"z-width", to_markdown(table)}};
  add_delays(section);
  section.pictures = {{"accuracy/z_width.svg", plot::to_svg(chart)}};
  return section;
}

}  // namespace telepalp::bench
