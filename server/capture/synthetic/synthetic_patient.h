#pragma once

#include <memory>

#include "server/capture/synthetic/colleague_visit.h"
#include "server/capture/synthetic/motion/patient_motion.h"
#include "server/capture/synthetic/sensor/sensor_model.h"
#include "server/capture/synthetic/shape/settings.h"
#include "server/capture/synthetic/true_surface.h"

namespace telepalp::capture {

/// A simulated, breathing patient on a table under an RGB-D camera. Frames and true surfaces are pure functions of
/// mesh, settings and time: they are reproducible, in any order and on any thread.
///
///   const auto mesh = read_mesh(...);
///   const auto patient = SyntheticPatient::make(*mesh, {.noise = DepthNoise::None, .disparity_steps = false});
///   const RgbdFrame frame = patient->frame_at(time, sequence);
///   const TrueSurface truth = patient->true_surface(time);
class SyntheticPatient {
 public:
  /// `where`: the mesh's name, for errors. Error: a setting out of its range, or a mesh that cannot be laid on the
  /// table as a patient.
  [[nodiscard]] static Result<SyntheticPatient> make(const TriangleMesh& mesh, const SyntheticSettings& settings,
                                                     const std::string& where = "synthetic patient");

  /// The camera's frame for an exposure at `time`; `captured` is `time`. Colour is registered to depth.
  [[nodiscard]] RgbdFrame frame_at(SessionTime time, std::uint64_t sequence) const;

  /// The camera's frame of a given pose, for scripted motions. `time` selects the noise. The colour ignores the pose.
  [[nodiscard]] RgbdFrame frame_of(const PatientPose& pose, SessionTime time, std::uint64_t sequence) const;
  [[nodiscard]] DepthImage depth_of(const PatientPose& pose, SessionTime time) const;  ///< without colour
  [[nodiscard]] TrueSurface surface_of(const PatientPose& pose) const noexcept;

  /// The noise-free surface of frame_at(time).
  [[nodiscard]] TrueSurface true_surface(SessionTime time) const;

  [[nodiscard]] const SyntheticSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] PatientPose pose(SessionTime time) const;

 private:
  SyntheticPatient(const SyntheticSettings& settings, RestShape rest);

  SyntheticSettings settings_;
  std::shared_ptr<const RestShape> rest_;  // shared with each returned TrueSurface
  SensorModel sensor_;
  PatientMotion motion_;
  ColorImage picture_;
};

}  // namespace telepalp::capture
