#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "haptic_station/core/prism_stage.h"
#include "haptic_station/station/bill/thread_time.h"
#include "tests/bench/distribution.h"
#include "tests/bench/needle/section.h"
#include "tests/haptic_station/tissue/fem/prism_runs.h"

namespace telepalp::bench {
namespace {

using Eigen::Vector3d;
using tissue::ElementOrder;

constexpr double kLong_m = 0.1;
constexpr double kPeriod_s = 0.016;

/// Cells of a mesh with cubes.
double cubes_per_Pa(int across, ElementOrder order, double poisson) {
  return tissue::stiffness_per_Pa(across, 5 * across, order, poisson);
}

/// A clamped beam of slenderness 5 with shear (Timoshenko), Cowper's coefficient for a rectangle [m].
double beam_per_Pa(double poisson) {
  constexpr double kSide_m = 0.02;
  const double area_m2 = kSide_m * kSide_m;
  const double shear_m2 = 10.0 * (1.0 + poisson) / (12.0 + 11.0 * poisson) * area_m2 / (2.0 * (1.0 + poisson));
  return 1.0 / (std::pow(kLong_m, 3) / (3.0 * area_m2 * area_m2 / 12.0) + kLong_m / shear_m2);
}

std::string text(const char* format, auto... values) {
  char line[200];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

/// The stiffness of the mesh that scenes use, and of others with the time of a step of their motion.
void add_stiffness(std::vector<Row>& rows) {
  const tissue::PrismGrid shipped;
  for (const double poisson : {0.3, 0.45}) {
    const double limit = converged_prism_per_Pa(poisson);
    const double ours = tissue::top_stiffness_N_per_m(tissue::rubber(shipped, poisson, 1.0));
    rows.push_back(
        at_most(text("fem: stiffness at the top, Poisson's ratio %g: error against the converged mesh", poisson),
                100.0 * std::abs(ours / limit - 1.0), "%", poisson < 0.4 ? 1.0 : 3.0));
    if (poisson < 0.4)
      rows.push_back(at_most("fem: stiffness at the top, Poisson's ratio 0.3: error against a Timoshenko beam",
                             100.0 * std::abs(ours / beam_per_Pa(poisson) - 1.0), "%", 3.0));
    rows.push_back(
        measured(text("fem: converged stiffness over that of a Timoshenko beam, Poisson's ratio %g", poisson),
                 limit / beam_per_Pa(poisson), "N/N"));
    const auto price = [&](const char* kind, int across, ElementOrder order) {
      rows.push_back(measured(
          text("fem: stiffness over the converged one, Poisson's ratio %g: %s, %d across", poisson, kind, across),
          cubes_per_Pa(across, order, poisson) / limit, "N/N"));
    };
    for (const int across : {1, 2, 4}) price("linear tetrahedra", across, ElementOrder::Linear);
    for (const int across : {1, 2, 3}) price("quadratic tetrahedra", across, ElementOrder::Quadratic);
  }
}

/// Processor time of a run of the slow stage, whose prism is bent by a moving contact `presses` times [ms].
Distribution run_ms(const tissue::PrismGrid& grid, int presses) {
  tissue::PrismSettings settings;
  settings.grid = grid;
  core::PrismStage stage({.model = *tissue::make_prism_model(settings), .slew = {}});
  const auto run = [&](double t) {
    const auto begun = std::chrono::round<Nanoseconds>(std::chrono::duration<double>(t));
    const core::ModelWanted wanted{.tool = {.device = {tissue::pressing_at(t)}},
                                   .begun = SessionTime(begun),
                                   .displayed_in = std::chrono::milliseconds(20)};
    (void)stage.model_at(wanted);
  };
  run(0.0);  // prepares the prism
  Distribution taken_ms;
  for (double t = kPeriod_s; t < presses * tissue::kPressing_s; t += kPeriod_s) {
    const std::int64_t before_ns = station::thread_ns();
    run(t);
    taken_ms.add(1e-6 * static_cast<double>(station::thread_ns() - before_ns));
  }
  return taken_ms;
}

void add_times(std::vector<Row>& rows) {
  const Distribution shipped_ms = run_ms({}, 8);
  rows.push_back(
      at_most("fem: a run of the slow stage in contact, processor time: p50", shipped_ms.p50(), "ms", 1e3 * kPeriod_s));
  rows.push_back(
      at_most("fem: a run of the slow stage in contact, processor time: p99", shipped_ms.p99(), "ms", 1e3 * kPeriod_s));
  rows.push_back(measured("fem: a run of the slow stage in contact, processor time: most", shipped_ms.max(), "ms"));
  for (const ElementOrder order : {ElementOrder::Linear, ElementOrder::Quadratic})
    for (const int across : {1, 2}) {
      const char* kind = order == ElementOrder::Linear ? "linear" : "quadratic";
      rows.push_back(
          measured(text("fem: the same with %s tetrahedra, %d across and %d along", kind, across, 5 * across),
                   run_ms({.across = across, .along = 5 * across, .grading = 1.0, .order = order}, 1).p50(), "ms"));
    }
}

/// The farthest that a node is from its place at rest, 3 s after the prism is left alone, over the prism's length.
double left_over(tissue::ElasticMotion& motion) {
  tissue::settle(motion, 3.0, kPeriod_s);
  return tissue::away_m(motion) / kLong_m;
}

/// A prism that is turned inside out, and one whose top is pushed with ten times the force of a device of 10 N.
void add_recovery(std::vector<Row>& rows) {
  const auto model = *tissue::make_prism_model({});
  tissue::ElasticMotion motion(model->body, model->settings.damping_per_s);
  for (const auto& [name, at] : tissue::inverted_states(*model->body)) {
    motion.put(at);
    rows.push_back(at_most(text("fem: a prism %s: distance from rest after 3 s, over its length", name),
                           left_over(motion), "m/m", 1e-6));
  }
  motion.put(tissue::mirrored(*model->body));
  rows.push_back(measured("fem: a prism mirrored at its floor: distance from rest after 3 s, over its length",
                          left_over(motion), "m/m"));
  motion.set_to_rest();
  constexpr double kPushes_N_per_m = 28000.0;
  tissue::PatchContact push{.patch = tissue::top_of(motion.body().mesh()), .stiffness_N_per_m = kPushes_N_per_m};
  double force_N = 0.0;
  for (int i = 1; i <= 120 && force_N < 100.0; ++i) {
    push.limit_m = -0.001 * i;
    for (int k = 0; k < 4; ++k) (void)motion.step(kPeriod_s, &push);
    force_N = kPushes_N_per_m * push.depth_m(motion.at());
  }
  rows.push_back(at_least("fem: force on the top of the overloaded prism", force_N, "N", 100.0));
  rows.push_back(measured("fem: displacement of the overloaded prism's top",
                          1e3 * (tissue::place_of(push.patch, motion.at()) - Vector3d(0.0, kLong_m, 0.0)).norm(),
                          "mm"));
  rows.push_back(at_most("fem: after ten times the force: distance from rest after 3 s, over its length",
                         left_over(motion), "m/m", 1e-6));
}

}  // namespace

double converged_prism_per_Pa(double poisson) {
  const double one = cubes_per_Pa(1, ElementOrder::Quadratic, poisson);
  const double two = cubes_per_Pa(2, ElementOrder::Quadratic, poisson);
  const double four = cubes_per_Pa(4, ElementOrder::Quadratic, poisson);
  return four - (four - two) * (four - two) / ((four - two) - (two - one));
}

std::vector<Row> run_needle_fem_section() {
  std::vector<Row> rows;
  add_recovery(rows);
  add_stiffness(rows);
  add_times(rows);
  return rows;
}

}  // namespace telepalp::bench
