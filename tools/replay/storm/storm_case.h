#pragma once

#include <span>
#include <string>

#include "tools/replay/scenario/scenario.h"

namespace telepalp::replay {

/// One run of a storm (a series of random runs): a patient, a scene, a hand's script, a network and faults.
struct StormCase {
  std::string motion = "regular";
  std::uint64_t patient_seed = 1;
  int width_px = 320;          ///< of the camera; few pixels, so that more seeds run in a night
  std::string scene = "skin";  ///< name of a scene in the library
  Scenario scenario{};
  double seconds = 10.0;
};

/// The case that `seed` draws. The same seed gives the same case on every machine.
[[nodiscard]] StormCase draw_case(std::uint64_t seed);

[[nodiscard]] std::string source_of(const StormCase& storm);

/// The command line that repeats a case, without the program's name.
[[nodiscard]] std::string command_line(const StormCase& storm);

/// Makes a case simpler by one part: no fault of one kind, one network impairment removed, a patient who breathes
/// regularly, the script HandScript::Examine, patient seed 1, or the scene "skin".
using Simplification = void (*)(StormCase& storm);
[[nodiscard]] std::span<const Simplification> simplifications() noexcept;

}  // namespace telepalp::replay
