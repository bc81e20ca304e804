#include "haptic_station/trials/trial_run.h"

#include <algorithm>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/trials/loop_station.h"

namespace telepalp::trials {
namespace {

using control::ControlOutput;

constexpr int kSampleEvery_ticks = 10;

/// Values of the previous tick, to measure steps.
struct Before {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d device_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d speed = Eigen::Vector3d::Zero();
  Eigen::Vector3d shown_m = Eigen::Vector3d::Zero();
};

void judge(const Before& before, const LoopStation& station, const ControlOutput& out, double tick_s,
           TrialFigures& figures) {
  figures.worst_force_step_N = std::max(figures.worst_force_step_N, (out.force.N - before.force_N).norm());
  figures.worst_shown_step_m = std::max(figures.worst_shown_step_m, (out.displayed_hand.m - before.shown_m).norm());
  figures.most_force_N = std::max(figures.most_force_N, out.force.N.norm());
  figures.least_passivity_J = std::min(figures.least_passivity_J, out.passivity_J);
  if (control::is_inside(out.phase)) figures.contact_s += tick_s;
  constexpr double kSurelyInside_m = 0.002;
  if (!control::is_inside(out.phase) && station.true_depth_m() > kSurelyInside_m) figures.unfelt_s += tick_s;
  if (out.phase == out.previous) return;
  ++figures.entries[static_cast<std::size_t>(out.phase) - 1];
  const Eigen::Vector3d moved_m = station.pair().true_device().m - before.device_m;
  const Eigen::Vector3d speed = station.pair().true_device_velocity().v;
  figures.worst_jump_m = std::max(figures.worst_jump_m, (moved_m - before.speed * tick_s).norm());
  figures.worst_speed_jump_m_per_s = std::max(figures.worst_speed_jump_m_per_s, (speed - before.speed).norm());
}

}  // namespace

TrialResult run_trial(device::Trial trial, const VirtualStationSettings& settings, TrialSkin& skin) {
  LoopStation station(settings, skin);
  const device::Waypoint& start = device::waypoints(trial).back();
  station.place({{0.0, 0.03, 0.0}}, {{start.x_m, start.height_m, start.z_m}});
  device::ScriptedIntention person(device::waypoints(trial), {});
  TrialResult result{.trial = trial, .surface = "", .figures = {}, .samples = {}, .transitions = {}};
  const auto ticks = static_cast<int>(device::duration_s(trial) / settings.tick_s);
  Before before;
  for (int i = 0; i < ticks; ++i) {
    const double now_s = station.time_s();
    before.device_m = station.pair().true_device().m;
    before.speed = station.pair().true_device_velocity().v;
    const ControlOutput out =
        station.step([&](const device::TrialView& view) { return person.step(view, settings.tick_s); }).control;
    if (i == 0) before.shown_m = out.displayed_hand.m;
    judge(before, station, out, settings.tick_s, result.figures);
    before.force_N = out.force.N;
    before.shown_m = out.displayed_hand.m;
    if (out.phase != out.previous) result.transitions.push_back({now_s, out.previous, out.phase, out.event});
    if (i % kSampleEvery_ticks == 0)
      result.samples.push_back({now_s, out.phase, station.pair().true_hand(), station.pair().true_device(),
                                out.displayed_hand, out.force, out.indentation.v.norm()});
  }
  return result;
}

VirtualStationSettings paper_settings() {
  VirtualStationSettings settings;
  const effects::Recipe recipes[] = {effects::SkinSettings{},
                                     effects::InnerCylinderSettings{.top_center = {{0.0, -0.03, 0.0}}}};
  settings.effects = core::bank_of(recipes);
  return settings;
}

const char* title(device::Trial trial) noexcept {
  switch (trial) {
    case device::Trial::IndentSeveralPoints:
      return "first trial: indent several points";
    case device::Trial::MoveWithin:
      return "second trial: move within the body";
    case device::Trial::FindCylinder:
      return "third trial: touch the cylinder";
    case device::Trial::FreeSearch:
      return "fourth trial: search freely";
    case device::Trial::PushSideways:
      return "two objects: push each sideways, and again";
    case device::Trial::InsertNeedle:
      return "a needle: in, out, in again, and beside";
  }
  return "";
}

}  // namespace telepalp::trials
