#pragma once

#include "tools/study/experiments/experiment.h"
#include "tools/study/experiments/rib_task.h"

namespace telepalp::study {

[[nodiscard]] std::span<const Drawn<RibCounter>> rib_counter_ranges() noexcept;

/// Ribs counted by touch alone, and with the finger under the skin drawn, at a light and a firm press. An own study in
/// S2's scene: S2 has none.
[[nodiscard]] Experiment rib_experiment(Chest chest);

}  // namespace telepalp::study
