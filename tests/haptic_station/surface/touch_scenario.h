#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "haptic_station/surface/build/surface_builder.h"
#include "haptic_station/surface/touch/touch.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "tests/haptic_station/periods.h"

namespace telepalp::testing {

/// The shipped torso under a camera without disparity steps, samples of 0.1 mm, with Gaussian noise.
struct TorsoSettings {
  double sigma_m = 0.001;
  double amplitude_m = 0.0;
  double rate_hz = 0.25;
  bool holes = true;
  std::uint64_t seed = 1;
};
[[nodiscard]] Result<capture::SyntheticPatient> torso(const TorsoSettings& settings);

[[nodiscard]] inline SessionTime scene_time(double seconds) { return session_time(0) + from_seconds(seconds); }

/// A snapshot with its capture time.
struct Captured {
  double at_s = 0.0;
  std::shared_ptr<const surface::SurfaceSnapshot> snapshot;
};

/// Snapshots of `patient` at 30 Hz from 0 to `until_s`, all through one builder; those before `keep_from_s` are built
/// and dropped. `lost(n)` true: frame n never arrives.
[[nodiscard]] std::vector<Captured> watch(
    const capture::SyntheticPatient& patient, const surface::SurfaceSettings& settings, const surface::Reach& reach,
    double until_s, double keep_from_s, const std::function<bool(int)>& lost = [](int) { return false; });

/// Result of a run at 2 kHz, compared with the true surface of the same instant.
struct TouchRun {
  std::vector<double> force_change_N;  ///< |F_n − F_{n−1}| for ticks in contact
  double force_rmse_N = 0.0;
  double force_max_N = 0.0;
  double lost_share = 0.0;  ///< share of ticks without contact, among those in which the true surface is indented
  double age_s_max = 0.0;
};

/// Touches at `device(t)` from `from_s` to `until_s` with snapshots that arrive `delay_s` after their capture; of
/// several waiting ones, only the newest is used. The first quarter of a second, in which contact is made, is not
/// judged.
[[nodiscard]] TouchRun run_touch(
    const capture::SyntheticPatient& patient, const std::vector<Captured>& snapshots,
    const std::function<Eigen::Vector3d(double)>& device, double from_s, double until_s, double delay_s,
    double stiffness_N_per_m, const std::function<bool(double)>& outage = [](double) { return false; });

/// A spot on the belly and the inward direction there, for presses.
struct Spot {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};
[[nodiscard]] Spot belly(const capture::SyntheticPatient& patient);

}  // namespace telepalp::testing
