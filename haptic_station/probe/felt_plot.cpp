#include "haptic_station/probe/felt_plot.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "haptic_station/trials/figure.h"
#include "support/program/files/whole_file.h"

namespace telepalp::probe {
namespace {

constexpr std::size_t kColumns = 800;  // about one for each pixel
constexpr int kFigureHeight = 260;

/// A curve over time, thinned by column with its extremes kept, so that no peak is lost.
trials::Curve curve(const std::vector<Felt>& felt, const std::string& name, const std::string& color,
                    const std::function<double(const Felt&)>& value) {
  trials::Curve out{name, color, {}, {}};
  const std::size_t stride = std::max<std::size_t>(1, felt.size() / kColumns);
  for (std::size_t from = 0; from < felt.size(); from += stride) {
    const auto begin = felt.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = felt.begin() + static_cast<std::ptrdiff_t>(std::min(felt.size(), from + stride));
    const auto less = [&](const Felt& a, const Felt& b) {
      const double of_a = value(a);
      const double of_b = value(b);
      return std::isnan(of_b) ? !std::isnan(of_a) : of_a < of_b;
    };
    auto [low, high] = std::minmax_element(begin, end, less);
    if (high < low) std::swap(low, high);
    for (const auto at : {low, high}) {
      if (!std::isfinite(value(*at))) continue;
      out.x.push_back(at->t_s);
      out.y.push_back(value(*at));
    }
  }
  return out;
}

/// Removes the characters that XML reserves; titles do not need them.
std::string plain(const std::string& text) {
  std::string out = text;
  for (char& letter : out)
    if (letter == '<' || letter == '>' || letter == '&' || static_cast<unsigned char>(letter) < 0x20) letter = '_';
  return out;
}

}  // namespace

Result<void> plot_felt(const std::filesystem::path& file, const std::vector<Felt>& felt, const std::string& title) {
  const trials::Figure figures[] = {
      {plain(title),
       "",
       "distance [mm]",
       {curve(felt, "device from the surface", "#0072b2", [](const Felt& one) { return 1e3 * one.distance_m; })},
       {}},
      {"",
       "",
       "force [N]",
       {curve(felt, "|F|", "#222222", [](const Felt& one) { return one.force_N.norm(); }),
        curve(felt, "x", "#d55e00", [](const Felt& one) { return one.force_N.x(); }),
        curve(felt, "y", "#009e73", [](const Felt& one) { return one.force_N.y(); }),
        curve(felt, "z", "#56b4e9", [](const Felt& one) { return one.force_N.z(); })},
       {}},
      {"",
       "time [s]",
       "step [us]",
       {curve(felt, "time of a step", "#cc79a7", [](const Felt& one) { return one.step_us; })},
       {}}};
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"" +
                    std::to_string(3 * kFigureHeight) + "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  int top = 0;
  for (const trials::Figure& figure : figures) {
    svg += "<g transform=\"translate(0 " + std::to_string(top) + ")\">\n" + trials::to_svg(figure) + "</g>\n";
    top += kFigureHeight;
  }
  return program::write_whole_file(file, svg + "</svg>\n", program::Readers::Group);
}

}  // namespace telepalp::probe
