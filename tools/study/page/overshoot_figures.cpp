#include "tools/study/page/overshoot_figures.h"

#include <cmath>
#include <limits>

#include "support/plot/palette.h"
#include "tools/study/figures/paper_table.h"

namespace telepalp::study {
namespace {

plot::Series interval_lines(std::span<const Interval> mm, std::string_view color) {
  plot::Series lines{.name = "", .x = {}, .y = {}, .color = std::string(color), .style = plot::Style::Path};
  for (std::size_t i = 0; i < mm.size(); ++i) {
    if (!std::isfinite(mm[i].mean)) continue;
    for (const double y : {mm[i].low, mm[i].high, std::numeric_limits<double>::quiet_NaN()}) {
      lines.x.push_back(static_cast<double>(i + 1));
      lines.y.push_back(y);
    }
  }
  return lines;
}

}  // namespace

plot::Chart overshoot_chart(std::size_t mechanisms) {
  return {.title = "Overshoot of each mechanism, with 95 % intervals",
          .x = {.label = "number of the mechanism in the table",
                .include = plot::Range{0.0, static_cast<double>(mechanisms + 1)}},
          .y = {.label = "overshoot [mm]", .include = plot::Range{0.0, 0.0}},
          .height_px = 340.0};
}

void add_overshoots(plot::Chart& chart, std::string_view name, std::span<const Interval> mm, std::string_view color) {
  plot::Series dots{
      .name = std::string(name), .x = {}, .y = {}, .color = std::string(color), .style = plot::Style::Dots};
  for (std::size_t i = 0; i < mm.size(); ++i) {
    if (!std::isfinite(mm[i].mean)) continue;
    dots.x.push_back(static_cast<double>(i + 1));
    dots.y.push_back(mm[i].mean);
  }
  chart.series.push_back(interval_lines(mm, color));
  chart.series.push_back(std::move(dots));
}

void add_paper(plot::Chart& chart) {
  plot::Series paper{.name = "S4, Table 2",
                     .x = {},
                     .y = paper_overshoots_mm(),
                     .color = std::string(plot::kBlack),
                     .style = plot::Style::Dots};
  for (std::size_t i = 1; i <= paper.y.size(); ++i) paper.x.push_back(static_cast<double>(i));
  chart.series.push_back(std::move(paper));
}

plot::HeatMap table_2_map(const std::string& title, const std::vector<double>& mm) {
  plot::HeatMap map{.title = title,
                    .x_label = "h, l_h [mm]",
                    .y_label = "linkage, phi",
                    .columns = {"0, 140", "0, 180", "80, 140", "80, 180"},
                    .rows = {},
                    .values = mm,
                    .width_px = 470.0};
  for (int linkage = 1; linkage <= 3; ++linkage)
    for (const char* phi : {"0", "π/2", "5π/6"}) map.rows.push_back(std::to_string(linkage) + ", " + phi);
  return map;
}

const std::string_view kTaskRules =
    "<dt>contact point</dt><dd>place of the needle's tip when it first touches the sac</dd>"
    "<dt>direction</dt><dd>along the needle, as it is at that instant</dd>"
    "<dt>stop</dt><dd>after the sac is punctured, the tip moves by less than 0.2 mm in 0.1 s. S4 takes several "
    "successive equal coordinates of its device, which a hand with tremor does not give</dd>"
    "<dt>overshoot</dt><dd>distance from the contact point to the tip at the stop, in that direction. It includes how "
    "far the sac is pushed in before it gives way</dd>";

}  // namespace telepalp::study
