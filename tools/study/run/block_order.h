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
  double first_guess = 0.0;           ///< how wrong the person's first idea of the sac's depth is: standard normal
  std::vector<std::size_t> training;  ///< all mechanisms; training takes the first ones
  std::vector<std::size_t> formal;    ///< all mechanisms in the order in which they are tried
};
/// `number`: of the person. The same for a simulated operator and for a person of this number.
[[nodiscard]] BlockOrder block_order(std::uint64_t seed, std::size_t number, Condition condition,
                                     std::size_t mechanisms);

}  // namespace telepalp::study
