#pragma once

#include <cstdint>
#include <memory>

#include "tests/bench/hand/patient.h"
#include "tests/bench/hand/run.h"

namespace telepalp::bench::hand {

inline constexpr double kColleague_m_per_s = 0.3;
inline constexpr double kColleagueStays_s = 10.0;

/// A colleague's hand, with its forearm to the image's edge, that comes to the patient, stays and leaves.
struct ColleagueVisit {
  std::shared_ptr<const capture::SyntheticPatient> patient;
  Point<DepthCamera> skin;   ///< place of the skin at rest at which the palm stays
  double over_m = 0.0;       ///< height of the palm's underside over the skin; 0: it lies on the skin and moves with it
  double heading_rad = 0.0;  ///< as in ColleagueHand
  double arm_rise_rad = 0.3;  ///< as in ColleagueHand
  bool from_above = false;    ///< comes down from 0.3 m higher; false: comes from the side
  double begins_s = 6.0;      ///< time at which the hand is just outside the image
  double fingers_hz = 1.3;    ///< rate at which the fingers move

  /// The hand at `time_s` over the patient at `pose`; nullopt: it is not in the picture.
  [[nodiscard]] std::optional<capture::ColleagueHand> at(double time_s, const capture::PatientPose& pose) const;
  /// From this time on, no image shows the hand.
  [[nodiscard]] double gone_s() const noexcept;
};

/// What the visit changed for the doctor, against the same run without it.
struct VisitCost {
  double outwards_m = 0.0;  ///< most by which the device is farther out
  double force_N = 0.0;     ///< most by which the device pushes harder along the skin's normal
  double work_mJ = 0.0;     ///< most by which the device has done more work on the hand since the visit began
  double again_s = 0.0;     ///< from the first image without the hand until the force is 90 % of the law's
};

}  // namespace telepalp::bench::hand
