#pragma once

#include <cstdint>

namespace telepalp::study {

/// Parts of the needle's study that draw independent numbers, for seed_of().
enum Part : std::uint64_t { kPerson = 1, kPlant, kOrder, kFirstGuess, kPenetration, kCheck, kConditions };

}  // namespace telepalp::study
