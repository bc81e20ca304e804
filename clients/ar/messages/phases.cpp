#include "clients/ar/messages/phases.h"

#include "support/plot/palette.h"

namespace telepalp::ar {

const std::array<PhaseWords, 9> kPhases{{
    {msg::PHASE_CYLINDER_UPPER, "cylinder_upper", "cylinder upper", "-3", -3, plot::kPurple},
    {msg::PHASE_AROUND_CYLINDER, "around_cylinder", "around cylinder", "-2", -2, plot::kVermilion},
    {msg::PHASE_CYLINDER_LATERAL, "cylinder_lateral", "cylinder lateral", "-1", -1, plot::kBlue},
    {msg::PHASE_IN_BODY, "in_body", "in body", "0", 0, plot::kOrange},
    {msg::PHASE_BODY_TO_PLANE, "body_to_plane", "body to plane", "1", 1, plot::kGreen},
    {msg::PHASE_OUT_BODY, "out_body", "out body", "2", 2, plot::kSky},
    {msg::PHASE_PLANE_TO_BODY, "plane_to_body", "plane to body", "3", 3, plot::kYellow},
    {msg::PHASE_RELEASED, "released", "released", "R", 4, plot::kGrey},
    {msg::PHASE_FAULTED, "faulted", "faulted", "F", 5, plot::kBlack},
}};

const PhaseWords& words_for(msg::Phase phase) noexcept {
  for (const PhaseWords& words : kPhases)
    if (words.phase == phase) return words;
  return kPhases.back();
}

}  // namespace telepalp::ar
