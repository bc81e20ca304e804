#pragma once

#include <memory>

#include "server/capture/synthetic/sensor/sensor_model.h"
#include "server/capture/synthetic/shape/settings.h"
#include "server/capture/synthetic/motion/patient_motion.h"
#include "server/capture/synthetic/true_surface.h"

namespace telepalp::server {

/// A patient lying on a table under a depth camera, breathing. Frames and the truth behind them are pure functions of
/// time: the same mesh, settings and time give the same bytes, in any order, on any thread.
///
///   const auto mesh = read_mesh(...);
///   const auto patient = SyntheticPatient::make(*mesh, {.noise = DepthNoise::None, .disparity_steps = false});
///   const RgbdFrame frame = patient->frame_at(time, sequence);
///   const TrueSurface truth = patient->true_surface(time);
class SyntheticPatient {
 public:
  /// `where` names the mesh in errors. Refused: settings out of their bounds, a mesh that is no patient.
  [[nodiscard]] static Result<SyntheticPatient> make(const TriangleMesh& mesh, const SyntheticSettings& settings,
                                                     const std::string& where = "synthetic patient");

  /// What the camera delivers for an exposure at `time`; `captured` is `time`. Colour is registered to depth.
  [[nodiscard]] RgbdFrame frame_at(SessionTime time, std::uint64_t sequence) const;

  /// The same of a pose that the caller gives, for scripted motions; `time` names the frame's noise.
  [[nodiscard]] RgbdFrame frame_of(const PatientPose& pose, SessionTime time, std::uint64_t sequence) const;
  [[nodiscard]] DepthImage depth_of(const PatientPose& pose, SessionTime time) const;  ///< without colour
  [[nodiscard]] TrueSurface surface_of(const PatientPose& pose) const noexcept;

  /// The surface that frame_at(time) measured.
  [[nodiscard]] TrueSurface true_surface(SessionTime time) const noexcept;

  [[nodiscard]] const SyntheticSettings& settings() const noexcept { return settings_; }
  [[nodiscard]] PatientPose pose(SessionTime time) const noexcept;

 private:
  SyntheticPatient(const SyntheticSettings& settings, RestShape rest);

  SyntheticSettings settings_;
  std::shared_ptr<const RestShape> rest_;  // shared with every TrueSurface handed out
  SensorModel sensor_;
  PatientMotion motion_;
  ColorImage picture_;
};

}  // namespace telepalp::server
