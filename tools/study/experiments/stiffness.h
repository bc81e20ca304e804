#pragma once

#include "tools/study/experiments/experiment.h"
#include "tools/study/jnd/staircase.h"

namespace telepalp::study {

/// What an observer sees while two prisms are pushed sideways. Paper S3 (docs/sources.md) 8.4 has the first two.
enum class Sight {
  Naive,      ///< the hand where it is: it sinks further than the tool
  Corrected,  ///< the hand at the tool
  None,       ///< nothing: the control that shows what the hand alone tells
};

/// How a threshold is found.
enum class ThresholdRule {
  Staircase,  ///< 1-up-3-down with unequal steps, kStaircaseTarget
  Quest,      ///< 100 trials, each at the mean of the threshold's distribution, kQuestTarget
};
inline constexpr double kQuestTarget = 0.75;
inline constexpr int kQuestTrials = 100;

inline constexpr double kPrism_N_per_m = 1400.0;    ///< S3 8.4: the nominal prism
inline constexpr double kCoupling_N_per_m = 200.0;  ///< S3 7: between handle and tool
/// The compared prism is stiffer than the nominal one by at most this share.
inline constexpr double kMostDifference = 4.0;

/// A simulated observer who judges stiffness.
struct StiffnessObserver {
  double push_N = 2.0;
  double push_spread = 0.15;    ///< SD of the push from trial to trial, natural logarithm
  double force_noise = 0.1;     ///< SD of the felt force, as a share
  double touch_noise = 0.2;     ///< SD of the stiffness that the hand alone tells, as a share
  double sight_noise = 0.04;    ///< SD of a seen displacement, as a share
  double sight_floor_m = 3e-4;  ///< SD of a seen displacement, at least
  double sight_weight = 0.9;    ///< share of sight in the judgement
  double hand_weight = 0.1;     ///< share of the seen hand, beside the seen tool, in the seen displacement
  double practice = 0.1;        ///< by so much all noise falls from the first condition to the last
  double lapses = 0.02;         ///< share of answers that are random
};
[[nodiscard]] std::span<const Drawn<StiffnessObserver>> stiffness_ranges() noexcept;

/// Pushes both prisms and tells which one seems stiffer. True: the one that is stiffer by `difference`.
[[nodiscard]] bool answers_right(const StiffnessObserver& person, Sight sight, double difference, double noise_scale,
                                 device::Random& random) noexcept;

/// S3 8.4 with simulated observers: the least difference in stiffness that is told.
[[nodiscard]] Experiment stiffness_experiment(ThresholdRule rule);

}  // namespace telepalp::study
