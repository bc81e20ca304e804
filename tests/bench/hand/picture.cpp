#include "tests/bench/hand/picture.h"

#include <cmath>

#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "support/program/files/whole_file.h"
#include "tests/bench/hand/delays.h"
#include "tests/bench/hand/patterns.h"
#include "tests/bench/hand/percussion.h"

namespace telepalp::bench::hand {
namespace {

constexpr int kDrawnEvery = 4;  // draws each fourth tick
constexpr double kHeight_px = 230.0;

struct Panel {
  const char* title;
  const char* pattern;
  double lasts_s;
  bool taps;
};
constexpr Panel kPanels[] = {
    {"Coughs of 8 mm in 0.3 s: the hand rests in the skin", "cough of 8 mm in 0.3 s", 10.0, false},
    {"Talk, syllables of 3 to 8 mm at 1 to 3 Hz: the hand rests in the skin", "talk", 8.0, false},
    {"Sit-up by 15 degrees and back: the hand rides on the skin", "sit-up", 20.0, false},
    {"Percussion at 4 Hz and 0.6 m/s during irregular breath", "irregular", 2.0, true}};

struct Curves {
  plot::Series law{.name = "the force law on the true skin", .x = {}, .y = {}, .color = std::string(plot::kBlack)};
  plot::Series station{.name = "telepalp", .x = {}, .y = {}, .color = std::string(plot::kVermilion)};
  plot::Series ideal{.name = "ideal display of the newest image",
                     .x = {},
                     .y = {},
                     .color = std::string(plot::kSky),
                     .style = plot::Style::Dashed};

  void add(double t, double law_N, double station_N, double ideal_N) {
    for (auto* curve : {&law, &station, &ideal}) curve->x.push_back(t);
    law.y.push_back(law_N);
    station.y.push_back(station_N);
    ideal.y.push_back(ideal_N);
  }
};

Curves play_picture(const Panel& panel) {
  const Pattern& moves = pattern(panel.pattern);
  const auto patient = torso();
  const Spot& spot = spots().front();
  const PoseScript pose = script(moves, patient, spot);
  Feed feed({.patient = patient, .pose = pose, .link = {.one_way_s = 0.1, .seed = 5}, .builder = {}});
  const auto placed = haptic_from_camera(*patient, spot);
  const Eigen::Vector3d normal = normal_at(*patient, spot).v;
  StationSettings settings = with_skin(effects::SkinAnchor::FollowsSurface);
  settings.control.limits.continuous_N = settings.control.limits.peak_N;  // motors that stay cool
  BenchStation station(settings, placed, std::make_unique<RigidHand>([&](double t, const control::ControlOutput&) {
                         if (panel.taps) return Point<HapticBase>{tapping(t, kFrom_s - 1.0).m * normal};
                         const double height_m = reaching_m(t, kDepth_m) + ridden_m(moves, pose, *patient, placed, t);
                         return Point<HapticBase>{{0.0, height_m, 0.0}};
                       }));
  Curves curves;
  run(feed, station, kFrom_s + panel.lasts_s, [&](const Tick& tick) {
    if (tick.time_s < kFrom_s || std::llround(tick.time_s / kTick_s) % kDrawnEvery != 0) return;
    curves.add(tick.time_s - kFrom_s, tick.law_N(), tick.pushed_N(),
               newest_image_N(feed, tick, placed).dot(tick.normal));
  });
  return curves;
}

}  // namespace

Result<void> draw_force(const std::filesystem::path& file) {
  std::vector<plot::Chart> charts;
  for (const Panel& panel : kPanels) {
    Curves curves = play_picture(panel);
    charts.push_back({.title = panel.title,
                      .x = {.label = &panel == std::end(kPanels) - 1 ? "time [s]" : ""},
                      .y = {.label = "force [N]"},
                      .series = {std::move(curves.ideal), std::move(curves.law), std::move(curves.station)},
                      .height_px = kHeight_px});
  }
  return program::write_whole_file(file, plot::to_svg_document(charts), program::Readers::Anyone);
}

}  // namespace telepalp::bench::hand
