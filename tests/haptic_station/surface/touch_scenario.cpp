#include "tests/haptic_station/surface/touch_scenario.h"

#include <algorithm>
#include <cmath>

#include "server/capture/synthetic/source/patient_model.h"

namespace telepalp::testing {

using Eigen::Vector3d;

Result<capture::SyntheticPatient> torso(const TorsoSettings& settings) {
  const Result<capture::TriangleMesh> mesh = capture::shipped_torso();
  if (!mesh) return mesh.error();
  capture::SyntheticSettings synthetic;
  synthetic.noise = settings.sigma_m > 0.0 ? capture::DepthNoise::Gaussian : capture::DepthNoise::None;
  synthetic.gaussian_sigma_m = settings.sigma_m;
  synthetic.disparity_steps = false;
  synthetic.holes = settings.holes;
  synthetic.amplitude_m = settings.amplitude_m;
  synthetic.rate_hz = settings.rate_hz;
  synthetic.depth_unit_m = 0.0001;
  synthetic.seed = settings.seed;
  return capture::SyntheticPatient::make(*mesh, synthetic);
}

std::vector<Captured> watch(const capture::SyntheticPatient& patient, const surface::SurfaceSettings& settings,
                            const surface::Reach& reach, double until_s, double keep_from_s,
                            const std::function<bool(int)>& lost) {
  surface::SurfaceBuilder builder(settings);
  std::vector<Captured> kept;
  for (int n = 0; n * kFrame_s < until_s; ++n) {
    if (lost(n)) continue;
    const RgbdFrame frame = patient.frame_at(scene_time(n * kFrame_s), static_cast<std::uint64_t>(n));
    auto snapshot = builder.add(frame.depth, frame.camera.depth, frame.captured, reach);
    if (snapshot && n * kFrame_s >= keep_from_s) kept.push_back({n * kFrame_s, std::move(snapshot)});
  }
  return kept;
}

TouchRun run_touch(const capture::SyntheticPatient& patient, const std::vector<Captured>& snapshots,
                   const std::function<Vector3d(double)>& device, double from_s, double until_s, double delay_s,
                   double stiffness_N_per_m, const std::function<bool(double)>& outage) {
  constexpr double kMeeting_s = 0.25;
  TouchRun run;
  surface::Touch touch;
  std::size_t next = 0;
  bool touched = false;
  Vector3d last_N = Vector3d::Zero();
  double square = 0.0;
  int indented = 0;
  int lost = 0;
  const int ticks = static_cast<int>((until_s - from_s) / kTick_s);
  for (int tick = 0; tick < ticks; ++tick) {
    const double t = from_s + tick * kTick_s;
    const surface::SurfaceSnapshot* newest = nullptr;
    if (!outage(t))
      for (; next < snapshots.size() && snapshots[next].at_s + delay_s <= t; ++next)
        newest = snapshots[next].snapshot.get();
    if (newest != nullptr) touch.adopt(*newest, scene_time(t));
    // Contact is made from outside, in the first tenth of a second.
    const Vector3d goal = device(t);
    const Vector3d at = goal * (1.0 - 0.05 * std::max(0.0, 1.0 - 10.0 * tick * kTick_s));
    const surface::TouchSample sample = touch.step({at}, scene_time(t), kTick_s);
    const Vector3d force_N = stiffness_N_per_m * (sample.proxy.m - at);
    run.force_max_N = std::max(run.force_max_N, force_N.norm());
    const bool judged = tick * kTick_s > kMeeting_s;
    const auto truth = patient.true_surface(scene_time(t)).closest_to({at});
    if (judged && truth && truth->normal.v.dot(at - truth->at.m) < -1e-4) {
      ++indented;
      if (!sample.in_body) ++lost;
      square += (force_N - stiffness_N_per_m * (truth->at.m - at)).squaredNorm();
      if (touched) run.force_change_N.push_back((force_N - last_N).norm());
      run.age_s_max = std::max(run.age_s_max, sample.age_s);
    }
    touched = judged;
    last_N = force_N;
  }
  run.force_rmse_N = std::sqrt(square / std::max(indented, 1));
  run.lost_share = static_cast<double>(lost) / std::max(indented, 1);
  return run;
}

Spot belly(const capture::SyntheticPatient& patient) {
  const Intrinsics& camera = patient.settings().camera;
  const auto point = patient.true_surface(scene_time(0.0)).at_pixel(camera.cx - 40.0, camera.cy + 20.0);
  return {point.at.m, point.normal.v};
}

}  // namespace telepalp::testing
