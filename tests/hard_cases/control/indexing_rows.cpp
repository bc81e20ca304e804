#include <cmath>
#include <numbers>

#include "proto/words/smooth_step.h"
#include "tests/hard_cases/claims.h"
#include "tests/hard_cases/control/loop_scene.h"
#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

using ::testing::AssertionResult;

constexpr double kDepth_m = 0.02;
constexpr double kPressed_s = 2.0;         // from here on the finger is kDepth_m deep
constexpr double kIndexedStep_N = 0.0601;  // the damping of a sliding finger begins with 0.06 N, anywhere on the skin

/// The finger's distance from the device's axis, along the body [m].
using Along = std::function<double(double now_s)>;

/// A smooth step from `from` to `to`, between the times `begin_s` and `end_s`.
double eased(double now_s, double begin_s, double end_s, double from, double to) {
  return from + (to - from) * smooth_step(std::clamp((now_s - begin_s) / (end_s - begin_s), 0.0, 1.0));
}

/// Figures of a run in which a finger holds the device on a path, whatever the force.
struct Indexing {
  Felt felt;
  double farthest_m = 0.0;          ///< largest shift of the patient by the indexing
  double body_N_while_off = 0.0;    ///< force out of the body, 0.2 s or more after the touch ended
  double body_N_at_re_entry = 0.0;  ///< force out of the body in the first 20 ms after a re-entry
  double last_N = 0.0;              ///< force out of the body at the end
  double most_recall_N = 0.0;
  int switches = 0;  ///< of the interaction, on or off
};

Indexing index(const Along& along, double seconds, bool on = true) {
  LoopScene scene;
  scene.seconds = seconds;
  scene.effects = the_skin({.law = {}, .anchor = effects::SkinAnchor::Sliding});
  scene.control.indexing.on = on;
  scene.tracker = [&](int tick, double now_s, const Point<HapticBase>&) {
    return tick % LoopScene::kTicksPerSample == 0 ? std::vector<TrackedHand>{{now_s, {{0.0, 0.0, along(now_s)}}}}
                                                  : std::vector<TrackedHand>{};
  };
  scene.encoders = [&](double now_s, ports::DeviceReading& reading) {
    reading.at.m = {0.0, eased(now_s, 0.5, kPressed_s, 0.05, -kDepth_m), along(now_s)};
    reading.velocity = {};
  };
  Indexing seen;
  double switched_s = 0.0;
  bool off = false;
  scene.watch = [&](const loop::TickOut& act, double now_s, const loop::HapticLoop& loop, const auto&) {
    seen.farthest_m = std::max(seen.farthest_m, loop.in_patient_frame({}).m.norm());
    if (act.sample.indexing != off) {
      off = act.sample.indexing;
      switched_s = now_s;
      ++seen.switches;
    }
    seen.last_N = act.force.N.y();
    if (off) seen.most_recall_N = std::max(seen.most_recall_N, -act.force.N.z());
    if (off && now_s > switched_s + 0.2) seen.body_N_while_off = std::max(seen.body_N_while_off, std::abs(seen.last_N));
    if (!off && seen.switches > 0 && now_s < switched_s + 0.02)
      seen.body_N_at_re_entry = std::max(seen.body_N_at_re_entry, std::abs(seen.last_N));
  };
  seen.felt = feel(scene);
  return seen;
}

AssertionResult out_and_back() {
  const Indexing seen =
      index([](double now_s) { return eased(now_s, 3.0, 4.0, 0.0, 0.12) - eased(now_s, 5.0, 6.0, 0.0, 0.06); }, 9.0);
  return all_of({{seen.switches == 2 && !seen.felt.faulted, "off once, on once"},
                 above("the patient moved", seen.farthest_m, 0.1, 1.0, "m"),
                 below_N("no force of the body meanwhile", seen.body_N_while_off, 1e-6),
                 below_N("re-entry begins without force", seen.body_N_at_re_entry, 0.05),
                 above("and the skin is felt again", seen.last_N, 0.9, 1.0, "N"),
                 below_N("step", seen.felt.worst_step_N, kIndexedStep_N)});
}

AssertionResult to_both_ends() {
  const Indexing feet = index([](double now_s) { return eased(now_s, 2.0, 3.0, 0.0, 0.13); }, 12.0);
  const Indexing head = index([](double now_s) { return eased(now_s, 2.0, 3.0, 0.0, -0.13); }, 12.0);
  return all_of({{feet.farthest_m == 0.9 && head.farthest_m == 0.9, "0.9 m to each end, with 0.1 m of touch beyond"},
                 below_N("the recall is bounded", feet.most_recall_N, 3.0 + 1e-9),
                 below_N("step", std::max(feet.felt.worst_step_N, head.felt.worst_step_N), kIndexedStep_N)});
}

AssertionResult trembling_at_the_border() {
  const Indexing seen = index(
      [](double now_s) {
        return eased(now_s, 2.5, 3.5, 0.0, 0.1) + 9e-4 * std::sin(2.0 * std::numbers::pi * 8.0 * now_s);
      },
      6.0);
  return all_of({{seen.switches <= 1, "switches once"}, below_N("step", seen.felt.worst_step_N, kIndexedStep_N)});
}

AssertionResult far_outside() {
  loop::WorkspaceIndexing indexing({.on = true});
  double fastest = 0.0;
  double most_N = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const loop::Indexed& now = indexing.step({{3e3, 0.0, -1e6}}, i % 2 == 0 ? 0.0005 : 1e9);
    fastest = std::max(fastest, now.moved.v.norm() / 0.01);
    most_N = std::max(most_N, now.recall.N.norm());
  }
  const Eigen::Vector3d held = indexing.now().shift.v;
  (void)indexing.step({{std::nan(""), 0.0, 0.0}}, 0.0005);
  return all_of({below_N("the recall is bounded", most_N, 3.0 + 1e-9),
                 below("the speed too", fastest, 0.15 + 1e-9, 1.0, "m/s"),
                 {std::abs(held.z()) == 0.9 && std::abs(held.x()) <= 0.3, "the shift ends at its bounds"},
                 {indexing.now().shift.v == held && indexing.now().recall.N.isZero(), "NaN: held, without force"}});
}

AssertionResult on_the_axis() {
  loop::WorkspaceIndexing indexing({.on = true, .touch_radius_m = 0.01});
  const loop::Indexed& now = indexing.step({}, 0.0005);
  return all_of({{now.interacts && now.recall.N.isZero() && now.shift.v.isZero(), "no direction, no force"}});
}

AssertionResult scene_without_a_workspace() {
  const Along far = [](double now_s) { return eased(now_s, 3.0, 4.0, 0.0, 0.3); };
  const Indexing seen = index(far, 5.0, false);
  return all_of({{seen.switches == 0 && seen.farthest_m == 0.0, "no shift, no switch"},
                 above("the skin is felt everywhere", seen.last_N, 0.9, 1.0, "N")});
}

}  // namespace

std::vector<HardCase> indexing_rows() {
  return {
      {"finger leaves its cylinder in contact", "the body stops pushing, and moves under it",
       "no jump when it stops, none when it pushes again", out_and_back},
      {"device pushed to both ends of the body", "a shift without bound loses the patient", "ends at its bounds",
       to_both_ends},
      {"hand trembles on the cylinder's border", "touch on and off at 8 Hz", "2 mm of hysteresis",
       trembling_at_the_border},
      {"device 1000 km away, NaN, bad dt", "force and speed are proportional to the distance", "both are bounded",
       far_outside},
      {"device on the cylinder's axis", "no direction is outwards", "no force", on_the_axis},
      {"scene without a workspace", "what is not named must cost nothing", "nothing shifts", scene_without_a_workspace},
  };
}

}  // namespace telepalp::hard_cases
