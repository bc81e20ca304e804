#include "support/plot/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "support/plot/bars.h"
#include "support/plot/palette.h"
#include "support/plot/svg.h"
#include "where.h"

namespace telepalp::plot {
namespace {

Chart tiny_chart() {
  Chart chart{.title = "force < 10 N & finite", .x = {"time [s]"}, .y = {"force [N]"}};
  chart.series.push_back({"norm", {0.0, 1.0, 2.0, 3.0}, {0.0, 4.0, std::nan(""), 2.0}, std::string(kBlue)});
  chart.bands.push_back({1.0, 3.0, std::string(kOrange), "in body", "0"});
  chart.rules.push_back({10.0, "peak 10 N", std::string(kVermilion)});
  chart.width_px = 480.0;
  chart.height_px = 240.0;
  return chart;
}

// Compares with the golden file. Rebuild it after a check of the change: TELEPALP_WRITE_GOLDEN=1 plot_test
void expect_golden(const std::string& svg, const std::string& name) {
  const std::string file = std::string(TELEPALP_SOURCE_DIR) + "/tests/clients/plot/golden/" + name;
  if (std::getenv("TELEPALP_WRITE_GOLDEN") != nullptr) std::ofstream(file) << svg;
  std::stringstream golden;
  golden << std::ifstream(file).rdbuf();
  EXPECT_EQ(svg, golden.str()) << "look at " << file;
}

TEST(Chart, ATinyChartEqualsTheGoldenFile) { expect_golden(to_svg(tiny_chart()), "tiny_chart.svg"); }

TEST(Chart, ATinyBarChartEqualsTheGoldenFile) {
  expect_golden(to_svg(BarChart{"latency",
                                "ms",
                                {{"capture to encoded", 2.0, 5.5, std::string(kSky)},
                                 {"decoded to touchable", std::nan(""), 1.0, std::string(kSky)}}}),
                "tiny_bars.svg");
}

std::vector<Pixel> drawn_points(const std::string& svg) {
  std::vector<Pixel> points;
  const std::regex curves("<path fill=\"none\"[^>]*stroke-width=\"1.6\"[^>]* d=\"([^\"]*)\"");
  const std::regex pair("[ML]([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator curve(svg.begin(), svg.end(), curves), none; curve != none; ++curve) {
    const std::string d = (*curve)[1];
    for (std::sregex_iterator at(d.begin(), d.end(), pair); at != none; ++at)
      points.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  }
  return points;
}

TEST(Chart, EveryDrawnPointLiesWithinTheFrameWhateverTheData) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-6.0, 6.0), sign(-1.0, 1.0);
  for (int round = 0; round < 200; ++round) {
    Chart chart = tiny_chart();
    chart.series.clear();
    for (const Style style : {Style::Line, Style::Dashed, Style::Step, Style::Path}) {
      Series series{"", {}, {}, std::string(kBlue), style};
      for (int i = 0; i < 50; ++i) {
        series.x.push_back(i);
        series.y.push_back(i % 7 == 3 ? std::nan("") : sign(random) * std::pow(10.0, exponent(random)));
      }
      chart.series.push_back(series);
    }
    const Frame frame = frame_of(chart);
    const auto points = drawn_points(to_svg(chart));
    ASSERT_GT(points.size(), 100U);
    for (const Pixel& point : points) {
      ASSERT_GE(point.x, frame.x_px.least - 0.01) << "seed 11, round " << round;
      ASSERT_LE(point.x, frame.x_px.most + 0.01) << "seed 11, round " << round;
      ASSERT_LE(point.y, frame.y_px.least + 0.01) << "seed 11, round " << round;
      ASSERT_GE(point.y, frame.y_px.most - 0.01) << "seed 11, round " << round;
    }
  }
}

TEST(Chart, SkipsValuesThatAreNotFiniteAndNeverWritesNan) {
  Chart chart = tiny_chart();
  chart.series[0].y = {std::nan(""), INFINITY, -INFINITY, std::nan("")};
  const std::string svg = to_svg(chart);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_TRUE(drawn_points(svg).empty());
}

TEST(Chart, LogarithmicAxesLeaveOutValuesBelowZero) {
  Chart chart = tiny_chart();
  chart.y.logarithmic = true;
  chart.series[0].y = {0.0, 1.0, 100.0, -3.0};
  EXPECT_EQ(drawn_points(to_svg(chart)).size(), 2U);
}

TEST(Chart, WithoutDataIsStillAChart) {
  const std::string svg = to_svg(Chart{.title = "nothing", .x = {"t"}, .y = {"y"}});
  EXPECT_NE(svg.find("nothing"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Chart, ABudgetBeyondTheDataIsWithinTheFrame) {
  const std::string svg = to_svg(tiny_chart());
  EXPECT_NE(svg.find("peak 10 N"), std::string::npos);
  EXPECT_NE(svg.find(">10</text>"), std::string::npos);
}

TEST(Chart, UntrustedTextCannotBreakTheMarkup) {
  Chart chart = tiny_chart();
  chart.title = "</svg><script>\"'&";
  EXPECT_EQ(to_svg(chart).find("<script"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::plot
