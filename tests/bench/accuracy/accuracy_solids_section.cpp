#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_proxy.h"
#include "support/plot/chart.h"
#include "support/plot/palette.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/distribution.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using solids::ProxySettings;
using solids::SolidTree;

constexpr ProxySettings kFinest{.rounds = 60, .tolerance_m = 1e-10, .remembers = false};
constexpr double kTip_m = 0.006;
constexpr double kSolid_N_per_m = 1200.0;

/// Places of a device that slides at up to 0.2 m/s over a solid and presses up to 8 mm into it.
struct Path {
  Vector3d middle = Vector3d::Zero();
  Vector3d swing = Vector3d::Zero();
};
Vector3d place(const Path& path, int tick) {
  const double t = 5e-4 * tick;
  return path.middle +
         Vector3d(path.swing.x() * std::sin(2.6 * t), path.swing.y() * std::sin(4.0 * t), path.swing.z() * std::sin(t));
}

struct ProxyPrice {
  double p50_m = 0.0;  ///< distance from the proxy of the finest setting
  double p99_m = 0.0;
  double elsewhere = 0.0;  ///< share of contact further than 1 mm from it: on the other side of a crease
  Distribution step_us;
  double jump_N = 0.0;  ///< change of the force from one tick to the next, p99.9
};

ProxyPrice price_of(const SolidTree& tree, const Path& path, const ProxySettings& settings, double tip_m = kTip_m) {
  constexpr int kTicks = 20'000;
  solids::SolidProxy proxy(settings);
  solids::SolidProxy truth(kFinest);
  ProxyPrice price;
  Distribution errors;
  double elsewhere = 0.0;
  Distribution jumps_N;
  Vector3d last_N = Vector3d::Zero();
  for (int tick = 0; tick < kTicks; ++tick) {
    const Vector3d device = place(path, tick);
    const auto before = std::chrono::steady_clock::now();
    const solids::ProxyAt at = proxy.step(tree, device, tip_m);
    price.step_us.add(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
    const solids::ProxyAt best = truth.step(tree, device, tip_m);
    const Vector3d force_N = kSolid_N_per_m * at.depth_m * at.outwards;
    jumps_N.add((force_N - last_N).norm());
    last_N = force_N;
    if (best.depth_m <= 0.0 && at.depth_m <= 0.0) continue;
    const double error_m = (at.at - best.at).norm();
    errors.add(error_m);
    if (error_m > 1e-3) elsewhere += 1.0;
  }
  price.jump_N = jumps_N.p999();
  if (errors.count() == 0) return price;
  price.p50_m = errors.p50();
  price.p99_m = errors.p99();
  price.elsewhere = elsewhere / static_cast<double>(errors.count());
  return price;
}

std::shared_ptr<const SolidTree> tree_of(const std::string& polish) {
  return *solids::build_tree(*solids::parse_polish(polish, "bench"));
}

struct TriedSettings {
  std::string name;
  ProxySettings settings;
  ProxyPrice price;
};

/// Rounds and tolerance on the shipped ribs.
std::vector<TriedSettings> settings_tried(const SolidTree& ribs) {
  const Path path{.middle = {0.05, -0.027, 0.0}, .swing = {0.02, 0.005, 0.1}};
  std::vector<TriedSettings> all;
  for (const int rounds : {1, 2, 3, 4, 6, 10, 20})
    all.push_back({std::to_string(rounds) + " rounds", {.rounds = rounds}, {}});
  for (const double tolerance_m : {1e-3, 1e-4, 1e-5, 1e-7, 1e-8})
    all.push_back({"within " + cell(1e6 * tolerance_m) + " µm", {.tolerance_m = tolerance_m}, {}});
  all.push_back({"the whole tree each time", {.remembers = false}, {}});
  for (TriedSettings& one : all) one.price = price_of(ribs, path, one.settings);
  return all;
}

PageTable settings_table(const std::vector<TriedSettings>& all) {
  PageTable table{.head = {"setting", "proxy error µm, p50", "p99", "over 1 mm, % of contact", "step µs, p50", "p99"},
                  .rows = {}};
  for (const TriedSettings& one : all) {
    const bool usual = one.settings.rounds == ProxySettings{}.rounds && one.settings.remembers &&
                       one.settings.tolerance_m == ProxySettings{}.tolerance_m;
    table.rows.push_back({usual ? "**" + one.name + "** (default)" : one.name, cell(1e6 * one.price.p50_m),
                          cell(1e6 * one.price.p99_m), cell(100.0 * one.price.elsewhere), cell(one.price.step_us.p50()),
                          cell(one.price.step_us.p99())});
  }
  return table;
}

plot::Chart chart_of(const std::vector<TriedSettings>& all) {
  plot::Chart chart{.title = "Proxy error against time of a step, on 24 ribs with a fingertip of 6 mm",
                    .x = {.label = "step, p50 [µs]", .logarithmic = true},
                    .y = {.label = "error, p99 [µm]", .logarithmic = true},
                    .height_px = 420.0};
  plot::Series dots{.name = {}, .x = {}, .y = {}, .color = std::string(plot::kBlue), .style = plot::Style::Dots};
  for (const TriedSettings& one : all) {
    const double p99_um = std::max(1e-4, 1e6 * one.price.p99_m);
    dots.x.push_back(one.price.step_us.p50());
    dots.y.push_back(p99_um);
    chart.marks.push_back({one.price.step_us.p50(), p99_um, one.name, std::string(plot::kGrey)});
  }
  chart.series.push_back(std::move(dots));
  return chart;
}

/// `count` balls in rows, 30 mm apart, on whose tops the finger slides.
std::string balls(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += std::string(i + 1 < count ? "+ " : "") + "tr " + std::to_string(0.03 * (i % 10) - 0.135) + " -0.02 " +
            std::to_string(0.03 * ((i / 10) % 10) - 0.135) + " tr 0 " + std::to_string(-0.03 * (i / 100)) +
            " 0 sphere 0.012 ";
  return text;
}

/// Size of the tree, with and without skipping, and the width of a blend.
PageTable trees_table(const SolidTree& ribs, std::vector<Row>& rows) {
  const Path over{.middle = {0.0, -0.008, 0.0}, .swing = {0.1, 0.005, 0.1}};
  const Path over_ribs{.middle = {0.05, -0.027, 0.0}, .swing = {0.02, 0.005, 0.1}};
  PageTable table{.head = {"tree", "proxy error µm, p50 / p99", "step µs, p50 / p99",
                           "step µs, p50 / p99, the whole tree each time"},
                  .rows = {}};
  const auto add = [&](const std::string& name, const SolidTree& tree, const Path& path) {
    const ProxyPrice usual = price_of(tree, path, {});
    const ProxyPrice whole = price_of(tree, path, {.remembers = false});
    rows.push_back(measured("proxy on " + name + ": proxy error, p99", 1e6 * usual.p99_m, "um"));
    rows.push_back(measured("proxy on " + name + ": time of a step, p50", usual.step_us.p50(), "us"));
    table.rows.push_back({name, cell(1e6 * usual.p50_m) + " / " + cell(1e6 * usual.p99_m),
                          cell(usual.step_us.p50()) + " / " + cell(usual.step_us.p99()),
                          cell(whole.step_us.p50()) + " / " + cell(whole.step_us.p99())});
  };
  add("24 ribs", ribs, over_ribs);
  for (const int count : {1, 10, 100, 1000, 10'000})
    add(std::to_string(count) + (count == 1 ? " ball" : " balls"), *tree_of(balls(count)), over);
  for (const double width_m : {0.0, 0.005, 0.01, 0.02, 0.04}) {
    const std::string two = " tr -0.015 -0.03 0 sphere 0.025 tr 0.015 -0.03 0 sphere 0.025";
    const std::string blend = width_m > 0.0 ? "blend " + std::to_string(width_m) : "+";
    add("two balls, blend of " + cell(1e3 * width_m) + " mm", *tree_of(blend + two),
        {.middle = {0.0, -0.004, 0.0}, .swing = {0.03, 0.004, 0.01}});
  }
  return table;
}

/// The radius of the fingertip on the shipped ribs.
PageTable tips_table(const SolidTree& ribs) {
  PageTable table{.head = {"`tip_radius_m`, mm", "step µs, p50 / p99", "proxy error µm, p50 / p99",
                           "change of the force in a tick mN, p99.9"},
                  .rows = {}};
  for (const double tip_m : {0.0, 0.003, 0.006, 0.01, 0.015}) {
    // The tip's centre lies a radius higher than the device point, so that each tip presses as deep.
    const Path path{.middle = {0.05, -0.033 + tip_m, 0.0}, .swing = {0.02, 0.005, 0.1}};
    const ProxyPrice price = price_of(ribs, path, {}, tip_m);
    table.rows.push_back({cell(1e3 * tip_m), cell(price.step_us.p50()) + " / " + cell(price.step_us.p99()),
                          cell(1e6 * price.p50_m) + " / " + cell(1e6 * price.p99_m), cell(1e3 * price.jump_N)});
  }
  return table;
}

}  // namespace

Result<Section> solids_section() {
  const auto scene = scenes::read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/ribs-ultrasound.scene.textproto");
  if (!scene) return scene.error();
  const SolidTree& ribs = *scene->layers().front().solid->tree;
  const std::vector<TriedSettings> all = settings_tried(ribs);
  Section section;
  for (const TriedSettings& one : all) {
    section.rows.push_back(
        measured("proxy on 24 ribs, " + one.name + ": proxy error, p99", 1e6 * one.price.p99_m, "um"));
    section.rows.push_back(
        measured("proxy on 24 ribs, " + one.name + ": time of a step, p50", one.price.step_us.p50(), "us"));
  }
  section.parts = {{"proxy", to_markdown(settings_table(all))},
                   {"trees", to_markdown(trees_table(ribs, section.rows))},
                   {"tips", to_markdown(tips_table(ribs))}};
  section.pictures = {{"accuracy/proxy.svg", plot::to_svg(chart_of(all))}};
  return section;
}

}  // namespace telepalp::bench
