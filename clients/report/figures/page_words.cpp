#include "clients/report/figures/page_words.h"

#include <array>
#include <string_view>

#include "clients/report/figures/html.h"
#include "support/plot/svg.h"

namespace telepalp::report {
namespace {

struct Word {
  std::string_view word;
  std::string_view meaning;
};

constexpr auto kWords = std::to_array<Word>({
    {"contact",
     "the hand presses the skin, or an object under it: the states in which the force comes from the patient"},
    {"display", "what the hand feels as the patient: the haptic device with the station's control loop"},
    {"drive",
     "the control that moves the haptic device while there is no contact; its force does not come from the patient"},
    {"end-effector", "the part of the haptic device that the hand meets or holds"},
    {"proxy", "the end-effector held on the skin; a spring between end-effector and proxy gives the force"},
    {"surface", "the skin as the station computes it from one depth image and those before it"},
    {"touchable", "of a depth image: its surface is ready for the control loop"},
    {"tick", "one step of the control loop, which runs 2000 times a second"},
    {"p50, p99, p99.9", "half, 1 % and 0.1 % of the samples are larger"},
});

}  // namespace

std::string page_words_section() {
  std::string list = "<dl class=\"meanings\">\n";
  for (const Word& word : kWords)
    list += "<dt>" + plot::escaped(word.word) + "</dt><dd>" + plot::escaped(word.meaning) + "</dd>\n";
  return section("Words on this page", "docs/glossary.md of telepalp has more.", list + "</dl>\n");
}

}  // namespace telepalp::report
