#include "tests/bench/effects/effects_bench.h"

#include <ctime>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <set>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/polish.h"
#include "haptic_station/solids/solid_mesh.h"
#include "haptic_station/solids/solid_proxy.h"
#include "haptic_station/ultrasound/b_mode.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/finger_study.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using solids::SolidTree;

constexpr const char* kScenes = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";

double thread_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

std::shared_ptr<const SolidTree> tree_of(const std::string& text) {
  return *solids::build_tree(*solids::parse_polish(text, "bench"));
}

/// A finger that slides over the ribs of the shipped scene, 0.1 m/s, 5 mm deep in them. Times are of the wall clock:
/// another program on the core shows in p99.9.
void measure_proxy(const SolidTree& ribs, Report& report) {
  Distribution us;
  solids::SolidProxy proxy;
  for (int i = 0; i < 60'000; ++i) {
    const double z = 0.1 * std::sin(i * 5e-4);
    const Vector3d device(0.05 + 0.02 * std::sin(i * 1.3e-3), -0.03 - 0.005 * std::sin(i * 2e-3), z);
    const auto before = std::chrono::steady_clock::now();
    (void)proxy.step(ribs, device);
    us.add(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
  }
  report.rows.push_back(at_least("ribs in the tree", static_cast<double>(ribs.shapes), "", 24.0));
  report.rows.push_back(at_most("24 ribs, proxy step, p50", us.p50(), "us", 2.0));
  report.rows.push_back(at_most("24 ribs, proxy step, p99.9", us.p999(), "us", 20.0));
}

/// Mean processor time of an evaluation near the surface of `count` separated spheres [us].
double evaluation_us(int count) {
  const int side = static_cast<int>(std::lround(std::cbrt(count)));
  std::string text;
  int made = 0;
  for (int i = 0; i < count; ++i) {
    text += std::string(i + 1 < count ? "+ " : "") + "tr " + std::to_string(i % side) + " " +
            std::to_string(i / side % side) + " " + std::to_string(i / side / side) + " sphere 0.2 ";
    ++made;
  }
  const auto tree = tree_of(text);
  std::mt19937_64 random(7);
  std::vector<Vector3d> places;
  for (int i = 0; i < 1000; ++i) {
    const int k = std::uniform_int_distribution(0, made - 1)(random);
    std::uniform_real_distribution off(-0.25, 0.25);
    places.emplace_back(k % side + off(random), k / side % side + off(random), k / side / side + off(random));
  }
  Distribution us;
  double sum = 0.0;
  for (int round = 0; round < 21; ++round) {
    const double before = thread_us();
    for (const Vector3d& place : places) sum += solids::solid_at(*tree, place).m;
    us.add((thread_us() - before) / static_cast<double>(places.size()));
  }
  return std::isfinite(sum) ? us.p50() : HUGE_VAL;
}

/// A cost that grows with the logarithm has a constant difference per factor of ten.
void measure_growth(Report& report) {
  const double one = evaluation_us(10);
  const double hundred = evaluation_us(100);
  const double thousand = evaluation_us(1000);
  const double ten_thousand = evaluation_us(10'000);
  report.rows.push_back(measured("evaluation, 10 solids", 1e3 * one, "ns"));
  report.rows.push_back(measured("evaluation, 100 solids", 1e3 * hundred, "ns"));
  report.rows.push_back(measured("evaluation, 1000 solids", 1e3 * thousand, "ns"));
  report.rows.push_back(measured("evaluation, 10000 solids", 1e3 * ten_thousand, "ns"));
  report.rows.push_back(at_most("10000 against 10 solids, log grows by 4", ten_thousand / one, "", 4.0));
}

void measure_gradient(const SolidTree& tree, Report& report) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution xz(-0.12, 0.12);
  std::uniform_real_distribution y(-0.08, 0.0);
  double worst = 0.0;
  int compared = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p(xz(random), y(random), xz(random));
    const solids::SolidAt at = solids::solid_at(tree, p);
    bool tie = false;
    Vector3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = [&](double h) {
        const solids::SolidAt there = solids::solid_at(tree, p + h * Vector3d::Unit(axis));
        tie = tie || there.part != at.part || (there.gradient - at.gradient).norm() > 0.02;
        return there.m;
      };
      const double wide = (value(1e-5) - value(-1e-5)) / 2e-5;
      slope[axis] = (4.0 * (value(5e-6) - value(-5e-6)) / 1e-5 - wide) / 3.0;
    }
    if (tie) continue;
    ++compared;
    worst = std::max(worst, (slope - at.gradient).norm());
  }
  report.rows.push_back(at_least("gradient: places away from ties", compared, "", 10'000.0));
  report.rows.push_back(at_most("gradient against differences, worst", worst, "", 1e-6));
}

void measure_ribs(const scenes::Scene& scene, Report& report) {
  int right = 0;
  double worst_N = 0.0;
  constexpr int kSeeds = 100;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const RibCount count = count_ribs(scene, static_cast<std::uint64_t>(seed));
    if (count.counted == count.crossed) ++right;
    worst_N = std::max(worst_N, count.worst_step_N);
  }
  report.rows.push_back(at_least("ribs counted from the force, of 100 seeds", right, "", kSeeds));
  report.rows.push_back(at_most("finger along the ribs, force change a tick", worst_N, "N", 0.05));
}

void measure_masses(Report& report) {
  for (const double size_mm : {10.0, 20.0, 30.0})
    for (const double depth_mm : {10.0, 20.0, 30.0})
      for (const double stiffness : {300.0, 900.0}) {
        int found = 0;
        constexpr int kSeeds = 20;
        for (int seed = 1; seed <= kSeeds; ++seed)
          if (finds_mass({1e-3 * size_mm, 1e-3 * depth_mm, stiffness}, static_cast<std::uint64_t>(seed))) ++found;
        char name[96];
        std::snprintf(name, sizeof name, "mass of %.0f mm, %.0f mm deep, %.0f N/m: found", size_mm, depth_mm,
                      stiffness);
        const double share = 100.0 * found / kSeeds;
        const bool asked = size_mm == 20.0 && depth_mm == 20.0 && stiffness == 900.0;
        report.rows.push_back(asked ? at_least(name, share, "%", 95.0) : measured(name, share, "%"));
      }
}

/// A scene is billed for the effects that it names.
Result<void> measure_absent(Report& report) {
  const auto plain = scenes::read_scene(std::string(kScenes) + "skin.scene.textproto");
  if (!plain) return plain.error();
  double others = 0.0;
  for (const effects::EffectBill& line : plain->effects.bill())
    if (std::string_view(line.name) != "skin") ++others;
  report.rows.push_back(at_most("effects billed to a scene of skin alone, beside it", others, "", 0.0));
  report.rows.push_back(at_most("solids held by that scene", static_cast<double>(plain->layers.size()), "", 0.0));
  return {};
}

void measure_image(const scenes::Scene& scene, Report& report) {
  Distribution ms;
  for (int i = 0; i < 40; ++i) {
    const double before = thread_us();
    const ultrasound::ProbePose probe{.at = {0.03, 0.0, 0.004 * i - 0.08}};
    if (ultrasound::b_mode(scene.layers, probe).gray.empty()) return;
    ms.add(1e-3 * (thread_us() - before));
  }
  report.rows.push_back(at_most("B-mode image 256x256, processor time, p50", ms.p50(), "ms", 15.0));
  report.rows.push_back(measured("B-mode image 256x256, processor time, max", ms.max(), "ms"));
}

void measure_mesh(const SolidTree& ribs, Report& report) {
  const auto mesh = solids::mesh_of(ribs, 0.003);
  report.rows.push_back(at_most("open edges of the ribs' mesh",
                                mesh ? static_cast<double>(solids::open_edges(*mesh)) : HUGE_VAL, "", 0.0));
}

}  // namespace

Result<Report> run_effects(const program::Arguments&) {
  Report report{.bench = "effects", .rows = {}, .notes = {}};
  const auto scene = scenes::read_scene(std::string(kScenes) + "ribs-ultrasound.scene.textproto");
  if (!scene) return scene.error();
  const SolidTree& ribs = *scene->layers.front()->tree;
  measure_proxy(ribs, report);
  measure_growth(report);
  measure_gradient(ribs, report);
  measure_ribs(*scene, report);
  measure_masses(report);
  if (const Result<void> done = measure_absent(report); !done) return done.error();
  measure_image(*scene, report);
  measure_mesh(ribs, report);
  report.notes.push_back(
      "ribs and masses: a finger under a level skin, with a tremor of 0.3 mm and a sensor's noise of 0.02 N");
  return report;
}

}  // namespace telepalp::bench
