#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace telepalp {

/// The two names of a phase of the encountered controller. `words` is what every picture, page, report and line shows a
/// doctor. `in_S1` is the name in paper S1 (docs/sources.md, Fig. 4), for readers of the paper; S1 has no name for the
/// phases without force, which repeat the glossary's word. Both are null-terminated.
struct PhaseName {
  std::string_view words;
  std::string_view in_S1;
};

/// By the number of telepalp.msg.Phase. The viewer's table (clients/viewer/src/words/phases.ts) and the glossary repeat
/// the words; a test compares all three.
inline constexpr std::array<PhaseName, 10> kPhaseNames{{
    {"No station", ""},
    {"Pressing the skin", "In body"},
    {"Lifting off", "Body to plane"},
    {"Above the skin", "Out body"},
    {"Approaching the skin", "Plane to body"},
    {"Side of an inner object", "Cylinder lateral"},
    {"Near an inner object", "Around cylinder"},
    {"On an inner object", "Cylinder upper"},
    {"Force paused", "Released"},
    {"Faulted", "Faulted"},
}};

/// The names of the phase `number` of telepalp.msg.Phase; "Unknown state" for a number of a newer program.
[[nodiscard]] constexpr PhaseName phase_name(int number) noexcept {
  if (number < 0 || static_cast<std::size_t>(number) >= kPhaseNames.size()) return {"Unknown state", "?"};
  return kPhaseNames[static_cast<std::size_t>(number)];
}

/// A change of phase as an event tells it: "Above the skin → Pressing the skin".
[[nodiscard]] inline std::string change_in_words(int from, int to) {
  return std::string(from == 0 ? "Start" : phase_name(from).words) + " → " + std::string(phase_name(to).words);
}

}  // namespace telepalp
