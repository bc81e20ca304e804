// The whole station in virtual time: a breathing synthetic patient, seen by a noisy camera 30 times a second, is built
// into surfaces and touched by a simulated hand at 2 kHz. The same loop runs on the haptic thread.

#include "haptic_station/loop/haptic_loop.h"

#include <gtest/gtest.h>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/loop/plane_snapshot.h"
#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/surface/build/surface_builder.h"
#include "proto/words/latest_value.h"
#include "server/capture/synthetic/shape/mesh.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "tests/haptic_station/periods.h"
#include "tests/support/no_heap_scope.h"
#include "where.h"

namespace telepalp::loop {
namespace {

SessionTime at_tick(int tick) { return session_time(1'000'000'000 + std::int64_t{tick} * 500'000); }

capture::SyntheticPatient breathing_patient() {
  const auto mesh = capture::read_mesh(TELEPALP_SOURCE_DIR "/deploy/demo_data/torso/visible_human_torso.ply");
  auto patient = capture::SyntheticPatient::make(mesh.value(), {});
  return std::move(patient).value();
}

scenes::Scene palpation() {
  auto scene = scenes::read_scene(TELEPALP_SOURCE_DIR "/haptic_station/scenes/palpation.scene.textproto");
  return std::move(scene).value();
}

struct Outcome {
  int in_body = 0;
  int out_body = 0;
  double largest_force_N = 0.0;
  double largest_step_N = 0.0;  ///< largest change of force in one tick in the body
  bool finite = true;
  Compensation most;  ///< largest magnitude of each figure

  void add(const Compensation& compensation) {
    const auto raise = [](double& most_so_far, double value) { most_so_far = std::max(most_so_far, std::abs(value)); };
    raise(most.hand_age_s, compensation.hand_age_s);
    raise(most.hand_carried_m, compensation.hand_carried_m);
    raise(most.hand_sigma_m, compensation.hand_sigma_m);
    raise(most.surface_age_s, compensation.surface_age_s);
    raise(most.surface_carried_m, compensation.surface_carried_m);
    raise(most.surface_sigma_m, compensation.surface_sigma_m);
    raise(most.shown_offset_m, compensation.shown_offset_m);
  }
  void add(const TickOut& act, const TickOut& before) {
    if (act.control.phase == control::Phase::OutBody) ++out_body;
    finite = finite && act.force.N.allFinite() && act.control.displayed_hand.m.allFinite();
    largest_force_N = std::max(largest_force_N, act.force.N.norm());
    if (!control::is_inside(act.control.phase)) return;
    ++in_body;
    if (control::is_inside(before.control.phase))
      largest_step_N = std::max(largest_step_N, (act.force.N - before.force.N).norm());
  }
};

/// Runs the station over `patient` for `seconds`. Ticks run in a NoHeapScope.
Outcome run(const capture::SyntheticPatient& patient, double seconds) {
  const scenes::Scene scene = palpation();
  const RgbdFrame first = patient.frame_at(at_tick(0), 0);
  const Point<DepthCamera> skin = station::point_under_center(first.depth, first.camera.depth).value();
  const auto haptic_from_camera = station::centered_on(scene.haptic_from_camera, skin);

  surface::SurfaceBuilder builder{surface::SurfaceSettings{}};
  LatestValue<TouchableSurface> surfaces;
  HapticLoop loop({}, control::EncounteredController(scene.control, core::bank_of(scene.effects)));
  SimulatedRig rig({.device = {}, .hand = {}, .tracker = {}, .rest = {{0.0, 0.1, 0.0}}},
                   device::ScriptedIntention(device::waypoints(scene.trial), {}));
  Outcome outcome;
  TickOut before;
  std::optional<surface::Reach> reach;
  for (int tick = 0; tick * kTick_s < seconds;) {
    const RgbdFrame frame = patient.frame_at(at_tick(tick), static_cast<std::uint64_t>(tick));
    surfaces.put({builder.add(frame.depth, frame.camera.depth, frame.captured, reach), haptic_from_camera});
    const test::NoHeapScope no_heap;
    for (int in_frame = 0; in_frame < kTicksPerFrame; ++in_frame, ++tick) {
      const SessionTime now = at_tick(tick);
      const TickOut act = loop.tick({.now = now,
                                     .dt_s = kTick_s,
                                     .hand = rig.hand(now),
                                     .reading = rig.read(),
                                     .surface = surfaces.take() ? &surfaces.current() : nullptr});
      rig.apply({act.force}, act.contact, kTick_s);
      outcome.add(act, before);
      outcome.add(loop.compensation());
      before = act;
    }
    reach =
        surface::Reach{.centre = haptic_from_camera.inverse() * before.contact.proxy, .radius_m = surface::kReach_m};
  }
  return outcome;
}

TEST(HapticLoop, TouchesABreathingPatientThroughANoisyCameraWithoutAHeap) {
  const Outcome outcome = run(breathing_patient(), 8.0);
  EXPECT_TRUE(outcome.finite);
  EXPECT_GT(outcome.in_body, 2000) << "one second of contact in eight";
  EXPECT_GT(outcome.out_body, 1000);
  EXPECT_LE(outcome.largest_force_N, 10.0);
  EXPECT_GT(outcome.largest_force_N, 0.3);
  // The limiter passes 1 N a tick (2000 N/s); a live surface must stay far below that.
  EXPECT_LE(outcome.largest_step_N, 0.1);
}

TEST(HapticLoop, ReportsEachCompensationOfDelayAndItsAmount) {
  const Compensation most = run(breathing_patient(), 4.0).most;
  EXPECT_NEAR(most.hand_age_s, 0.010, 0.002) << "the tracker's period";
  EXPECT_NEAR(most.surface_age_s, 0.0335, 0.001) << "a frame's period, without a network";
  EXPECT_GT(most.hand_carried_m, 0.001) << "a hand at 0.3 m/s, 10 ms later";
  EXPECT_LT(most.hand_carried_m, 0.01);
  EXPECT_GT(most.hand_sigma_m, 0.0);
  EXPECT_GT(most.surface_carried_m, 1e-5);
  EXPECT_LT(most.surface_carried_m, 0.002) << "a breath moves no faster than 25 mm/s";
  EXPECT_GT(most.surface_sigma_m, 0.0);
  EXPECT_GT(most.shown_offset_m, 0.005) << "the drawn hand stays on the skin, the tracked one is in it";
}

TEST(HapticLoop, TellsTheHandsAttitudePredictedToNowInTheCamerasFrame) {
  HapticLoop loop({}, control::EncounteredController({}, {}));
  const Eigen::Quaterniond camera_turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  PlaneSnapshot plane(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), 1.0);
  TouchableSurface surface{std::shared_ptr<const surface::SurfaceSnapshot>(&plane, [](const auto*) {}), {}};
  surface.haptic_from_camera.iso.linear() = camera_turn.toRotationMatrix();
  const auto turned = [](int tick) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(2.0 * tick * kTick_s, Eigen::Vector3d::UnitY()));
  };
  TickSample sample;
  for (int tick = 0; tick < 2010; ++tick) {
    if (tick == 10) {
      EXPECT_EQ(sample.hand_attitude_camera, (std::array<float, 4>{})) << "no hand yet";
    }
    TickIn in{.now = at_tick(tick),
              .dt_s = kTick_s,
              .reading = {.at = {{0.0, 0.03, 0.0}}, .velocity = {}},
              .surface = tick == 0 ? &surface : nullptr};
    if (tick >= 10 && tick % 20 == 0) in.hand = {at_tick(tick), {{0.0, 0.02, 0.0}}, turned(tick)};
    sample = loop.tick(in).sample;
  }
  const auto& q = sample.hand_attitude_camera;
  const Eigen::Quaterniond got(q[3], q[0], q[1], q[2]);
  EXPECT_LT(got.angularDistance(camera_turn.conjugate() * turned(2009)), 0.002);
}

TEST(HapticLoop, WithoutASurfaceThereIsNoForce) {
  const scenes::Scene scene = palpation();
  HapticLoop loop({}, control::EncounteredController(scene.control, core::bank_of(scene.effects)));
  for (int tick = 0; tick < 2000; ++tick) {
    const TickOut out = loop.tick({.now = at_tick(tick),
                                   .dt_s = kTick_s,
                                   .hand = ports::HandSample{at_tick(tick), {{0.0, 0.02, 0.0}}},
                                   .reading = {.at = {{0.0, -0.02, 0.0}}, .velocity = {}}});
    EXPECT_EQ(out.force.N.norm(), 0.0);
  }
}

}  // namespace
}  // namespace telepalp::loop
