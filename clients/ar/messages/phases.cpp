#include "clients/ar/messages/phases.h"

#include "proto/words/phase_names.h"
#include "support/plot/palette.h"

namespace telepalp::ar {
namespace {

constexpr std::string_view words_of(msg::Phase phase) noexcept { return phase_name(static_cast<int>(phase)).words; }

}  // namespace

const std::array<PhaseWords, 9> kPhases{{
    {msg::PHASE_CYLINDER_UPPER, "cylinder_upper", words_of(msg::PHASE_CYLINDER_UPPER), "-3", -3, plot::kPurple},
    {msg::PHASE_AROUND_CYLINDER, "around_cylinder", words_of(msg::PHASE_AROUND_CYLINDER), "-2", -2, plot::kVermilion},
    {msg::PHASE_CYLINDER_LATERAL, "cylinder_lateral", words_of(msg::PHASE_CYLINDER_LATERAL), "-1", -1, plot::kBlue},
    {msg::PHASE_IN_BODY, "in_body", words_of(msg::PHASE_IN_BODY), "0", 0, plot::kOrange},
    {msg::PHASE_BODY_TO_PLANE, "body_to_plane", words_of(msg::PHASE_BODY_TO_PLANE), "1", 1, plot::kGreen},
    {msg::PHASE_OUT_BODY, "out_body", words_of(msg::PHASE_OUT_BODY), "2", 2, plot::kSky},
    {msg::PHASE_PLANE_TO_BODY, "plane_to_body", words_of(msg::PHASE_PLANE_TO_BODY), "3", 3, plot::kYellow},
    {msg::PHASE_RELEASED, "released", words_of(msg::PHASE_RELEASED), "R", 4, plot::kGrey},
    {msg::PHASE_FAULTED, "faulted", words_of(msg::PHASE_FAULTED), "F", 5, plot::kBlack},
}};

const PhaseWords& words_for(msg::Phase phase) noexcept {
  for (const PhaseWords& words : kPhases)
    if (words.phase == phase) return words;
  return kPhases.back();
}

}  // namespace telepalp::ar
