#pragma once

#include <array>
#include <string_view>

#include "messages/station.pb.h"

namespace telepalp::ar {

/// How clients show a state of S1 Fig. 4.
struct PhaseWords {
  msg::Phase phase;
  std::string_view key;    ///< in report.json
  std::string_view words;  ///< name in report.html
  std::string_view mark;   ///< S1's number s_f; a letter for the two states that S1 does not have
  double level;            ///< vertical position in the timeline
  std::string_view color;
  bool contact;  ///< true: skin or inner objects give force
};

/// All states, ordered from deepest in the body to farthest from contact.
extern const std::array<PhaseWords, 9> kPhases;

/// The entry of `phase`; for an unknown number the entry of `faulted`, so that the error is visible.
[[nodiscard]] const PhaseWords& words_for(msg::Phase phase) noexcept;

}  // namespace telepalp::ar
