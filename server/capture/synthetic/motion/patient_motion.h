#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "proto/words/time.h"
#include "server/capture/synthetic/motion/breath_sequence.h"
#include "server/capture/synthetic/motion/patient_pose.h"

namespace telepalp::capture {

/// Kinds of motion of the patient. In all but Regular, the patient breathes irregularly.
enum class Motion {
  Regular,    ///< breathes as sin^4, all breaths equal
  Irregular,  ///< each breath: period within 20 %, amplitude within 30 % of the mean; random shape and lift at its end
  Cough,      ///< coughs one to four times, about every six seconds
  Hold,       ///< holds the breath for eight of twenty seconds
  Speech,     ///< short inhales, long exhales with syllables
  Shift,      ///< every six seconds, moves to up to 20 mm from rest along the table, and -10 to 20 mm in height
  Drift,      ///< sinks and rises by up to 5 mm, at up to 2 mm/s
  SitUp,      ///< sits up by 14 to 24 degrees for some seconds, every thirty seconds
};

/// The motion's NAME in `--source synthetic:…,motion=NAME`.
[[nodiscard]] std::string_view name(Motion motion) noexcept;
[[nodiscard]] std::optional<Motion> motion_named(std::string_view name) noexcept;
[[nodiscard]] std::span<const Motion> all_motions() noexcept;

/// The pose of a patient at any time: a pure, continuously differentiable function of (motion, amplitude, rate, seed,
/// time). Only Regular is a sum of a few harmonics, so a predictor that fits a few harmonics cannot fit the other
/// motions exactly.
class PatientMotion {
 public:
  PatientMotion(Motion motion, double amplitude_m, double rate_hz, std::uint64_t seed);

  [[nodiscard]] PatientPose at(SessionTime time) const noexcept;

 private:
  Motion motion_;
  double amplitude_m_;
  double rate_hz_;
  std::uint64_t seed_;
  BreathSequence breaths_;
};

}  // namespace telepalp::capture
