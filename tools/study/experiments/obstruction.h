#pragma once

#include "tools/study/experiments/experiment.h"
#include "tools/study/experiments/push_task.h"

namespace telepalp::study {

[[nodiscard]] std::span<const Drawn<Pusher>> pusher_ranges() noexcept;
[[nodiscard]] std::span<const Drawn<PushDesk>> desk_ranges() noexcept;

/// Paper S3 (docs/sources.md) 8.3 with simulated observers: a ball is pushed six times between two pockets, with the
/// haptic device in sight or hidden.
[[nodiscard]] Experiment obstruction_experiment();

}  // namespace telepalp::study
