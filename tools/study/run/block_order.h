#pragma once

#include <cstdint>
#include <vector>

#include "tools/study/person/operator.h"

namespace telepalp::study {

/// S4 section 6: training with a few random mechanisms, five penetrations each, before all mechanisms.
inline constexpr int kTrainingMechanisms = 3;
inline constexpr int kTrainingPenetrations = 5;

/// What chance decides about one person in one condition.
struct BlockOrder {
  double first_guess = 0.0;  ///< error of the person's first idea of the sac's depth, in its standard deviations
  std::vector<std::size_t> training;  ///< all mechanisms; training takes the first ones
  std::vector<std::size_t> formal;    ///< all mechanisms in the order in which they are tried
};
/// The order of the person with this number. It does not depend on whether the person is simulated.
[[nodiscard]] BlockOrder block_order(std::uint64_t seed, std::size_t number, Condition condition,
                                     std::size_t mechanisms);

}  // namespace telepalp::study
