#include "tests/bench/users/sections.h"
#include "tests/haptic_station/control/turning_path.h"

namespace telepalp::bench {

/// Defect that fails the rows: effects that see the device's attitude although it lacks torque (the last row's value).
Result<std::vector<Row>> run_tool_section(const UsersPlace&) {
  constexpr std::uint64_t kSeed = 29;
  constexpr int kSteps = 100'000;
  const control::ClosedPaths seen = control::closed_paths(kSeed, kSteps, control::Handles::VirtualTool);
  const control::ClosedPaths naive = control::closed_paths(kSeed, kSteps, control::Handles::DeviceAttitude);
  return std::vector<Row>{
      at_least("six sensed, three driven: steps on closed paths", seen.steps, "", kSteps),
      at_most("six sensed, three driven: energy gained", seen.gained_J, "J", 0.0),
      at_most("six sensed, three driven: energy gained in the worst lap", 1e6 * seen.worst_lap_J, "uJ", 1.0),
      measured("the same paths with the device's attitude: energy gained", naive.gained_J, "J"),
  };
}

}  // namespace telepalp::bench
