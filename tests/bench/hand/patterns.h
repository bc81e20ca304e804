#pragma once

#include <span>
#include <string_view>

#include "tests/bench/hand/feed.h"
#include "tests/bench/hand/patient.h"

namespace telepalp::bench::hand {

/// A way in which a patient moves. A breath of 5 mm lifts the skin at the touched spot by 5 mm, although the spot moves
/// less than the middle of the belly.
struct Pattern {
  std::string_view name;
  capture::PatientPose (*pose)(double time_s);  ///< breath.lift_m: lift of the skin at the spot [m]
  double rides_after_s;                         ///< delay at which the hand follows when the whole body rises or tilts
};

/// The breaths of a patient who lies still, at rest and disturbed.
[[nodiscard]] std::span<const Pattern> breaths() noexcept;
[[nodiscard]] const Pattern& sit_up() noexcept;
[[nodiscard]] const Pattern& talk() noexcept;
/// Coughs as the synthetic patient's, coughs of 8 mm in 0.3 s, and a shift of 10 mm in 50 ms.
[[nodiscard]] std::span<const Pattern> jolts() noexcept;

/// The pattern of this name; aborts if there is none.
[[nodiscard]] const Pattern& pattern(std::string_view name);

/// The patient's pose over time. The lift of the belly is chosen so that the skin at `spot` moves as `pattern` says.
[[nodiscard]] PoseScript script(const Pattern& pattern, std::shared_ptr<const capture::SyntheticPatient> patient,
                                const Spot& spot);

/// The height in H [m] by which a hand has followed a patient who shifts, rises or tilts. It follows with the delay
/// Pattern::rides_after_s. `pose`: the script of `pattern`.
[[nodiscard]] double ridden_m(const Pattern& pattern, const PoseScript& pose, const capture::SyntheticPatient& patient,
                              const Transform<HapticBase, DepthCamera>& haptic_from_camera, double time_s);

}  // namespace telepalp::bench::hand
