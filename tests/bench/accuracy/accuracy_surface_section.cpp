#include <algorithm>
#include <array>
#include <cmath>

#include "support/plot/chart.h"
#include "support/plot/number.h"
#include "support/plot/palette.h"
#include "tests/bench/accuracy/accuracy_pareto.h"
#include "tests/bench/accuracy/accuracy_sections.h"
#include "tests/bench/accuracy/accuracy_surface.h"

namespace telepalp::bench {
namespace {

struct TriedVariant {
  SurfaceVariant variant;
  SurfaceFigures figures;
};

std::string percent(double share) { return cell(100.0 * share); }

std::string with_mark(double value, bool holds) { return cell(value) + (holds ? "" : " ✗"); }

PageTable surface_table(const std::vector<TriedVariant>& all, const std::vector<std::size_t>& front, std::size_t knee) {
  PageTable table{.head = {"setting", "neighbours by", "support", "normals", "shapes µm", "shapes °", "torso mm",
                           "torso °", "jump µm", "build ms p50 / p99", "step µs p50 / p99", "load %", ""},
                  .rows = {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SurfaceFigures& f = all[i].figures;
    const bool on_front = std::find(front.begin(), front.end(), i) != front.end();
    table.rows.push_back(
        {all[i].variant.named ? "`" + all[i].variant.name + "`" : all[i].variant.name, all[i].variant.index,
         all[i].variant.support, all[i].variant.normals,
         touched(f.shapes, with_mark(1e6 * f.shapes.position_m, 1e6 * f.shapes.position_m <= kShapeReach_um)),
         with_mark(f.shapes.normal_deg, f.shapes.normal_deg <= kShapeReach_deg),
         touched(f.torso, with_mark(1e3 * f.torso.position_m, 1e3 * f.torso.position_m <= kTorsoReach_mm)),
         with_mark(f.torso.normal_deg, f.torso.normal_deg <= kTorsoReach_deg),
         with_mark(f.jump_um, f.jump_um <= kJumpReach_um), cell(f.build_p50_ms) + " / " + cell(f.build_p99_ms),
         cell(f.step_p50_us) + " / " + cell(f.step_p99_us), percent(f.load()),
         i == knee ? "**knee**" : (on_front ? "front" : "")});
  }
  return table;
}

/// Labels of the plot: the knee and the default, then the named settings whose labels do not overlap.
std::vector<plot::Mark> marks_of(const std::vector<TriedVariant>& all, std::size_t knee) {
  std::vector<std::size_t> order;
  if (knee < all.size()) order.push_back(knee);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].variant.named && i != knee) order.push_back(i);
  std::vector<plot::Mark> marks;
  for (const std::size_t i : order) {
    const double x = 100.0 * all[i].figures.load();
    const double y = 1e3 * all[i].figures.torso.position_m;
    const auto near = std::find_if(marks.begin(), marks.end(), [&](const plot::Mark& mark) {
      return std::abs(std::log10(mark.x / x)) < 0.15 && std::abs(std::log10(mark.y / y)) < 0.05;
    });
    const std::string name = all[i].variant.name + (i == knee ? " (knee)" : "");
    if (near == marks.end())
      marks.push_back({x, y, name, std::string(plot::kBlack)});
    else if (all[i].variant.name == surface::SurfaceSettings{}.name)
      near->name += "; beside it " + name + " (default)";
  }
  return marks;
}

std::vector<plot::Tick> ticks(std::initializer_list<double> at) {
  std::vector<plot::Tick> all;
  for (const double value : at) all.push_back({value, plot::number(value)});
  return all;
}

plot::Chart pareto_chart(const std::vector<TriedVariant>& all, const std::vector<std::size_t>& front,
                         std::size_t knee) {
  plot::Chart chart{.title = "Position error against computing time, torso with 1 mm noise after one second",
                    .x = {.label = "share of one core for live touch [%]",
                          .include = plot::Range{3.0, 500.0},
                          .logarithmic = true,
                          .ticks = ticks({3, 5, 10, 20, 50, 100, 200, 500})},
                    .y = {.label = "position error, RMS [mm]",
                          .include = plot::Range{0.015, 1.0},
                          .logarithmic = true,
                          .ticks = ticks({0.02, 0.05, 0.1, 0.2, 0.5, 1.0})}};
  chart.height_px = 460.0;
  const std::array<std::pair<const char*, std::string_view>, 3> families{
      {{"lattice", plot::kBlue}, {"paper", plot::kVermilion}, {"cloud", plot::kGreen}}};
  plot::Series line{"Pareto front", {}, {}, std::string(plot::kGrey), plot::Style::Path};
  for (const std::size_t i : front) {
    line.x.push_back(100.0 * all[i].figures.load());
    line.y.push_back(1e3 * all[i].figures.torso.position_m);
  }
  chart.series.push_back(std::move(line));
  for (const auto& [family, color] : families) {
    plot::Series dots{family, {}, {}, std::string(color), plot::Style::Dots};
    for (const TriedVariant& tried : all)
      if (tried.variant.family == family) {
        dots.x.push_back(100.0 * tried.figures.load());
        dots.y.push_back(1e3 * tried.figures.torso.position_m);
      }
    chart.series.push_back(std::move(dots));
  }
  chart.marks = marks_of(all, knee);
  chart.rules.push_back({kTorsoReach_mm, "asked: at most 0.25 mm", std::string(plot::kPurple)});
  return chart;
}

const TriedVariant& named(const std::vector<TriedVariant>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const TriedVariant& tried) { return tried.variant.name == name; });
}

std::string ratio(double a, double b) { return cell(a / b); }

/// The reason for the default setting, with figures of this run.
std::string knee_text(const std::vector<TriedVariant>& all, std::size_t knee) {
  const std::string name = surface::SurfaceSettings{}.name;
  const TriedVariant& usual = named(all, name);
  const TriedVariant& paper = named(all, "paper");
  if (knee == all.size()) return "No setting meets every requirement in this run, so there is no knee.\n";
  const TriedVariant& best = all[knee];
  const auto product = [](const TriedVariant& tried) { return tried.figures.torso.position_m * tried.figures.load(); };
  std::string text = "**The knee is `" + best.variant.name +
                     "`**: of the settings that meet every requirement above, it has the "
                     "least product of position error on the torso and load. ";
  constexpr double kAsGood = 1.10;  // a smaller difference is within the noise and cannot be felt
  if (best.variant.name == name)
    text += "It is the default.\n";
  else if (usual.figures.right_enough() && product(usual) <= kAsGood * product(best))
    text += "The default, `" + name + "`, is as good to within 10 %: its position error is " +
            ratio(usual.figures.torso.position_m, best.figures.torso.position_m) + " times, its load " +
            ratio(usual.figures.load(), best.figures.load()) + " times and their product " +
            ratio(product(usual), product(best)) + " times the knee's.\n";
  else
    text += "The default is `" + name + "`: its position error is " +
            ratio(usual.figures.torso.position_m, best.figures.torso.position_m) + " times and its load " +
            ratio(usual.figures.load(), best.figures.load()) + " times the knee's, the product " +
            ratio(product(usual), product(best)) + " times" +
            (usual.figures.right_enough() ? "" : "; and it misses a requirement above") + ".\n";
  text += "\nAgainst the paper's own surface, the default's position error is " +
          ratio(paper.figures.torso.position_m, usual.figures.torso.position_m) + " times smaller, its load " +
          ratio(paper.figures.load(), usual.figures.load()) + " times smaller, and f jumps by " +
          cell(usual.figures.jump_um) + " µm instead of " + cell(paper.figures.jump_um) + " µm for 1 µm of travel.\n";
  return text;
}

void add_rows(const TriedVariant& tried, bool is_default, std::vector<Row>& rows) {
  const SurfaceFigures& f = tried.figures;
  const std::string name = tried.variant.name + ": ";
  const auto row = [&](const std::string& what, double value, const char* unit, double reach) {
    rows.push_back(is_default ? at_most(name + what, value, unit, reach) : measured(name + what, value, unit));
  };
  row("shapes, RMS position error", 1e6 * f.shapes.position_m, "um", kShapeReach_um);
  row("shapes, RMS error of the normal", f.shapes.normal_deg, "deg", kShapeReach_deg);
  row("torso, RMS position error", 1e3 * f.torso.position_m, "mm", kTorsoReach_mm);
  row("torso, RMS error of the normal", f.torso.normal_deg, "deg", kTorsoReach_deg);
  row("largest change of f over 1 um of travel", f.jump_um, "um", kJumpReach_um);
  rows.push_back(measured(name + "time to build a snapshot, p50", f.build_p50_ms, "ms"));
  rows.push_back(measured(name + "time to build a snapshot, p99", f.build_p99_ms, "ms"));
  row("time of a proxy step, p50", f.step_p50_us, "us", kStepReach_us);
  rows.push_back(measured(name + "time of a proxy step, p99", f.step_p99_us, "us"));
  rows.push_back(measured(name + "load of one core", 100.0 * f.load(), "%"));
}

Result<PageTable> noise_table(std::vector<Row>& rows) {
  struct Sight {
    std::string name;
    Result<FilmedTorso> torso;
  };
  std::vector<Sight> sights;
  for (const double sigma_m : {0.0, 0.0005, 0.002, 0.004})
    sights.push_back({"noise " + cell(1e3 * sigma_m) + " mm", filmed_torso(sigma_m)});
  for (const double above_m : {0.8, 1.2, 2.0})
    sights.push_back({"a Kinect at " + cell(above_m) + " m", kinect_torso(above_m)});
  PageTable table{.head = {"setting"}, .rows = {}};
  for (const Sight& sight : sights) {
    if (!sight.torso) return sight.torso.error();
    table.head.push_back(sight.name + ", mm / °");
  }
  table.head.push_back("build ms");
  for (const SurfaceVariant& variant : few_variants()) {
    table.rows.push_back({"`" + variant.name + "`"});
    double build_ms = 0.0;
    for (const Sight& sight : sights) {
      const TouchError error = torso_touch_error(*sight.torso, variant);
      build_ms += error.build_ms / static_cast<double>(sights.size());
      table.rows.back().push_back(both(error, 1e3));
      rows.push_back(
          measured(variant.name + ": RMS position error, torso, " + sight.name, 1e3 * error.position_m, "mm"));
    }
    table.rows.back().push_back(cell(build_ms));
  }
  return table;
}

PageTable density_table(std::vector<Row>& rows) {
  PageTable table{.head = {"setting"}, .rows = {}};
  const std::vector<SurfaceVariant> few = few_variants();
  for (const SurfaceVariant& variant : few) table.rows.push_back({"`" + variant.name + "`"});
  for (const double spacing_m : {0.00075, 0.0015, 0.003, 0.006}) {
    table.head.push_back(cell(1e3 * spacing_m) + " mm, µm / °; build ms");
    const std::vector<RenderedShape> shapes = rendered_shapes(spacing_m);
    for (std::size_t k = 0; k < few.size(); ++k) {
      const TouchError error = shape_touch_error(shapes[2], few[k]);
      table.rows[k].push_back(both(error, 1e6) + "; " + cell(error.build_ms));
      rows.push_back(
          measured(few[k].name + ": RMS position error, sphere of 50 mm, points " + cell(1e3 * spacing_m) + " mm apart",
                   1e6 * error.position_m, "um"));
    }
  }
  return table;
}

}  // namespace

Result<Section> surface_section() {
  const std::vector<RenderedShape> shapes = rendered_shapes(0.0015);
  const Result<FilmedTorso> torso = filmed_torso(0.001);
  if (!torso) return torso.error();
  std::vector<TriedVariant> all;
  std::vector<Tradeoff> tradeoffs;
  Section section;
  for (const SurfaceVariant& variant : surface_variants())
    all.push_back({variant, measure_surface(variant, shapes, *torso)});
  for (TriedVariant& tried : all) measure_cost_again(tried.variant, *torso, tried.figures);
  for (const TriedVariant& tried : all) {
    tradeoffs.push_back({tried.figures.torso.position_m, tried.figures.load(), tried.figures.right_enough()});
    add_rows(tried, tried.variant.name == surface::SurfaceSettings{}.name, section.rows);
  }
  const std::vector<std::size_t> front = pareto_front(tradeoffs);
  const std::size_t knee = knee_of(tradeoffs);
  if (knee < all.size()) {
    const TriedVariant& usual = named(all, surface::SurfaceSettings{}.name);
    section.rows.push_back(measured(
        "product of error and load: default, divided by the knee (" + all[knee].variant.name + ")",
        usual.figures.torso.position_m * usual.figures.load() / (tradeoffs[knee].error * tradeoffs[knee].cost), "x"));
  }
  const Result<PageTable> noise = noise_table(section.rows);
  if (!noise) return noise.error();
  section.parts = {{"surface", to_markdown(surface_table(all, front, knee))},
                   {"knee", knee_text(all, knee)},
                   {"noise", to_markdown(*noise)},
                   {"density", to_markdown(density_table(section.rows))}};
  section.pictures = {{"accuracy/surface.svg", plot::to_svg(pareto_chart(all, front, knee))}};
  return section;
}

}  // namespace telepalp::bench
