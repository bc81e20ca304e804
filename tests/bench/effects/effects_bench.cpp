#include "tests/bench/effects/effects_bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <set>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/solid_mesh.h"
#include "haptic_station/solids/solid_proxy.h"
#include "haptic_station/ultrasound/b_mode.h"
#include "tests/bench/distribution.h"
#include "tests/bench/effects/finger_study.h"
#include "tests/bench/effects/growth_study.h"
#include "tests/bench/effects/thread_time.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using solids::SolidTree;

constexpr const char* kScenes = TELEPALP_SOURCE_DIR "/haptic_station/scenes/";

/// A finger that slides over the ribs of the shipped scene, 0.1 m/s, 5 mm deep in them. Times are of the wall clock:
/// another program on the core shows in p99.9. `tip_m`: radius of the fingertip, whose centre is `high_m` higher.
Distribution proxy_steps_us(const SolidTree& ribs, double tip_m, double high_m, double& contact) {
  Distribution us;
  solids::SolidProxy proxy;
  constexpr int kTicks = 60'000;
  contact = 0.0;
  for (int i = 0; i < kTicks; ++i) {
    const double z = 0.1 * std::sin(i * 5e-4);
    const Vector3d device(0.05 + 0.02 * std::sin(i * 1.3e-3), -0.03 - 0.005 * std::sin(i * 2e-3) + high_m, z);
    const auto before = std::chrono::steady_clock::now();
    const solids::ProxyAt at = proxy.step(ribs, device, tip_m);
    us.add(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - before).count());
    if (at.depth_m > 0.0) contact += 1.0 / kTicks;
  }
  return us;
}

void measure_proxy(const SolidTree& ribs, Report& report) {
  double contact = 0.0;
  const Distribution point = proxy_steps_us(ribs, 0.0, 0.0, contact);
  report.rows.push_back(at_least("number of shapes in the scene's ribs", static_cast<double>(ribs.shapes), "", 24.0));
  report.rows.push_back(at_most("proxy step on 24 ribs: time, p50", point.p50(), "us", 2.0));
  report.rows.push_back(at_most("proxy step on 24 ribs: time, p99.9", point.p999(), "us", 20.0));
  report.rows.push_back(measured("proxy step on 24 ribs: share of ticks in contact", contact, ""));
  const Distribution tip = proxy_steps_us(ribs, 0.006, 0.004, contact);
  report.rows.push_back(at_most("proxy step on 24 ribs, fingertip of 6 mm: time, p50", tip.p50(), "us", 2.0));
  report.rows.push_back(at_most("proxy step on 24 ribs, fingertip of 6 mm: time, p99.9", tip.p999(), "us", 20.0));
  report.rows.push_back(measured("proxy step on 24 ribs, fingertip of 6 mm: share of ticks in contact", contact, ""));
}

/// Difference between the gradient and central differences, the smallest over four step sizes. A wrong gradient is
/// wrong at each of them. Wide steps may straddle a place where the gradient has a kink, narrow ones suffer from
/// rounding. Infinite if each step size reaches another part or a kink.
double gradient_error(const SolidTree& tree, const Vector3d& p) {
  const solids::SolidAt at = solids::solid_at(tree, p);
  double least = HUGE_VAL;
  for (const double h : {1e-5, 3e-6, 1e-6, 3e-7}) {
    bool tie = false;
    Vector3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = [&](double step) {
        const solids::SolidAt there = solids::solid_at(tree, p + step * Vector3d::Unit(axis));
        tie = tie || there.part != at.part || (there.gradient - at.gradient).norm() > 0.02;
        return there.m;
      };
      slope[axis] = (value(h) - value(-h)) / (2.0 * h);
    }
    if (!tie) least = std::min(least, (slope - at.gradient).norm());
  }
  return least;
}

void measure_gradient(const SolidTree& tree, Report& report) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution xz(-0.12, 0.12);
  std::uniform_real_distribution y(-0.08, 0.0);
  double worst = 0.0;
  int compared = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vector3d p(xz(random), y(random), xz(random));
    const double error = gradient_error(tree, p);
    if (!std::isfinite(error)) continue;
    ++compared;
    worst = std::max(worst, error);
  }
  report.rows.push_back(at_least("gradient of the ribs' distance: number of places compared", compared, "", 10'000.0));
  report.rows.push_back(
      at_most("gradient of the ribs' distance: difference from finite differences, worst", worst, "", 1e-6));
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
  report.rows.push_back(
      at_least("number of 100 runs in which the ribs are counted rightly from the force", right, "", kSeeds));
  report.rows.push_back(at_most("finger across the ribs: largest force change in one tick", worst_N, "N", 0.05));
}

double found_percent(const std::optional<Mass>& mass, int seeds, double& hand_s) {
  int found = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const MassSearch search = search_mass(mass, static_cast<std::uint64_t>(seed));
    if (mass ? search.right : search.named) ++found;
    hand_s = search.hand_s;
  }
  return 100.0 * found / seeds;
}

void measure_masses(Report& report) {
  double hand_s = 0.0;
  for (const double size_mm : {10.0, 20.0, 30.0})
    for (const double depth_mm : {10.0, 20.0, 30.0})
      for (const double stiffness : {300.0, 900.0}) {
        const bool asked = size_mm == 20.0 && depth_mm == 20.0 && stiffness == 900.0;
        const double share = found_percent(Mass{1e-3 * size_mm, 1e-3 * depth_mm, stiffness}, asked ? 40 : 10, hand_s);
        char name[96];
        std::snprintf(name, sizeof name,
                      "mass of %.0f mm, %.0f mm deep, %.0f N/m: share of searches that find the mass", size_mm,
                      depth_mm, stiffness);
        report.rows.push_back(asked ? at_least(name, share, "%", 95.0) : measured(name, share, "%"));
        if (asked)
          report.rows.push_back(measured("mass of 20 mm, 20 mm deep, 900 N/m: time of one search", hand_s, "s"));
      }
  report.rows.push_back(
      at_most("no mass: share of searches that report a mass", found_percent({}, 40, hand_s), "%", 0.0));
}

/// A scene is billed for the effects that it names.
Result<void> measure_absent(Report& report) {
  const auto plain = scenes::read_scene(std::string(kScenes) + "skin.scene.textproto");
  if (!plain) return plain.error();
  double others = 0.0;
  const effects::EffectBank bank = core::bank_of(plain->effects);
  for (const effects::EffectBill& line : bank.bill())
    if (std::string_view(line.name) != "skin") ++others;
  report.rows.push_back(at_most("scene with skin alone: number of other effects in its bill", others, "", 0.0));
  report.rows.push_back(
      at_most("scene with skin alone: number of solids", static_cast<double>(plain->layers().size()), "", 0.0));
  return {};
}

void measure_image(const scenes::Scene& scene, Report& report) {
  Distribution ms;
  for (int i = 0; i < 40; ++i) {
    const double before = thread_us();
    const ultrasound::ProbePose probe{.at = {0.03, 0.0, 0.004 * i - 0.08}};
    if (ultrasound::b_mode(scene.solids(), probe).gray.empty()) return;
    ms.add(1e-3 * (thread_us() - before));
  }
  report.rows.push_back(at_most("B-mode image 256x256, processor time, p50", ms.p50(), "ms", 15.0));
  report.rows.push_back(measured("B-mode image 256x256, processor time, max", ms.max(), "ms"));
}

void measure_mesh(const SolidTree& ribs, Report& report) {
  const auto mesh = solids::mesh_of(ribs, 0.003);
  report.rows.push_back(at_most("number of open edges of the ribs' mesh",
                                mesh ? static_cast<double>(isosurface::facts_of(*mesh).open_edges) : HUGE_VAL, "",
                                0.0));
}

}  // namespace

Result<Report> run_effects(const program::Arguments&) {
  Report report{.bench = "effects", .rows = {}, .notes = {}};
  const auto scene = scenes::read_scene(std::string(kScenes) + "ribs-ultrasound.scene.textproto");
  if (!scene) return scene.error();
  const SolidTree& ribs = *scene->layers().front().solid->tree;
  measure_proxy(ribs, report);
  measure_growth(report);
  measure_gradient(ribs, report);
  measure_ribs(*scene, report);
  measure_masses(report);
  if (const Result<void> done = measure_absent(report); !done) return done.error();
  measure_image(*scene, report);
  measure_mesh(ribs, report);
  report.notes.push_back(
      "ribs and masses: under level skin; finger with a tremor of 0.3 mm and a force sensor with noise of 0.02 N");
  return report;
}

}  // namespace telepalp::bench
