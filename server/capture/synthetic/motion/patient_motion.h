#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "proto/words/time.h"
#include "server/capture/synthetic/motion/breath_sequence.h"
#include "server/capture/synthetic/motion/patient_pose.h"

namespace telepalp::server {

/// What the patient does, by name.
enum class Motion {
  Regular,    ///< breathes as sin^4, every breath like the last
  Irregular,  ///< period within 20 %, amplitude within 30 %, shape and rest level drawn for each breath
  Cough,      ///< and coughs one to four times, every six seconds or so
  Hold,       ///< and holds the breath for eight of twenty seconds
  Speech,     ///< short inhales, long exhales with syllables on them
  Shift,      ///< and moves by up to 20 mm sideways and from -10 to 20 mm in height, every six seconds or so
  Drift,      ///< and sinks and rises slowly by up to 5 mm, at up to 2 mm/s
  SitUp,      ///< and sits up by 14 to 24 degrees for some seconds in every thirty
};

/// The name that `--source synthetic:…,motion=NAME` takes.
[[nodiscard]] std::string_view name(Motion motion) noexcept;
[[nodiscard]] std::optional<Motion> motion_named(std::string_view name) noexcept;
[[nodiscard]] std::span<const Motion> all_motions() noexcept;

/// The pose of a patient at any time: a pure function of (motion, amplitude, rate, seed, time), continuous with its
/// rate. No motion but Regular is a sum of a few harmonics: a predictor that fits some cannot fit these.
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

}  // namespace telepalp::server
