#pragma once

#include <array>
#include <string_view>

#include "messages/station.pb.h"

namespace telepalp::report {

/// A state of S1 Fig. 4 as reports show it.
struct PhaseWords {
  msg::Phase phase;
  std::string_view key;    ///< in report.json
  std::string_view words;  ///< for people
  std::string_view mark;   ///< S1's number s_f; a letter for the two states that S1 does not have
  double level;            ///< where a timeline draws it
  std::string_view color;
  bool contact;  ///< the skin, or what lies under it, gives force
};

/// Every state, from the deepest inside the body to the one furthest from a touch.
extern const std::array<PhaseWords, 9> kPhases;

/// The words for `phase`; those of `faulted` for a number that no state has, so that it is seen.
[[nodiscard]] const PhaseWords& words_for(msg::Phase phase) noexcept;

}  // namespace telepalp::report
