#include "haptic_station/probe/felt_plot.h"

#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "support/program/files/whole_file.h"

namespace telepalp::probe {
namespace {

template <class Of>
plot::Series over_time(const std::vector<Felt>& felt, const char* name, std::string_view color, Of&& of) {
  plot::Series series{.name = name, .x = {}, .y = {}, .color = std::string(color)};
  for (const Felt& one : felt) {
    series.x.push_back(one.t_s);
    series.y.push_back(of(one));
  }
  return series;
}

}  // namespace

Result<void> plot_felt(const std::filesystem::path& file, const std::vector<Felt>& felt, const std::string& title) {
  const std::vector<plot::Chart> charts{
      {.title = title,
       .x = {.label = ""},
       .y = {.label = "distance [mm]"},
       .series = {over_time(felt, "distance of the device from the surface; negative in the body", plot::kBlue,
                            [](const Felt& one) { return 1e3 * one.distance_m; })}},
      {.title = "",
       .x = {.label = ""},
       .y = {.label = "force on the device [N]"},
       .series = {over_time(felt, "magnitude", plot::kBlack, [](const Felt& one) { return one.force_N.norm(); }),
                  over_time(felt, "along x", plot::kVermilion, [](const Felt& one) { return one.force_N.x(); }),
                  over_time(felt, "along y", plot::kGreen, [](const Felt& one) { return one.force_N.y(); }),
                  over_time(felt, "along z", plot::kSky, [](const Felt& one) { return one.force_N.z(); })}},
      {.title = "",
       .x = {.label = "time [s]"},
       .y = {.label = "computing time [us]"},
       .series = {
           over_time(felt, "computing time of a step", plot::kPurple, [](const Felt& one) { return one.step_us; })}}};
  return program::write_whole_file(file, plot::to_svg_document(charts), program::Readers::Group);
}

}  // namespace telepalp::probe
