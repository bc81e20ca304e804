#pragma once

#include <array>
#include <string_view>

#include "messages/station.pb.h"

namespace telepalp::ar {

/// Names, position and colour with which clients show a state of the controller (paper S1, Fig. 4; docs/sources.md).
struct PhaseWords {
  msg::Phase phase;
  std::string_view key;    ///< name in report.json
  std::string_view words;  ///< name for people, from proto/words/phase_names.h
  std::string_view mark;   ///< S1's state number s_f; R (released) and F (faulted) are not in S1
  double level;            ///< vertical position in the timeline
  std::string_view color;
};

/// All states, ordered from deepest in the body to farthest from contact.
extern const std::array<PhaseWords, 9> kPhases;

/// The entry of `phase`; for an unknown number the entry of `faulted`, so that the error is visible.
[[nodiscard]] const PhaseWords& words_for(msg::Phase phase) noexcept;

}  // namespace telepalp::ar
