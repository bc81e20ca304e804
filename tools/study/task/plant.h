#pragma once

#include "haptic_station/tissue/tissue_settings.h"
#include "tools/study/person/parameter.h"

namespace telepalp::study {

/// What S4 does not give: one value for each operator, drawn from the ranges of plant_ranges().
struct Plant {
  double l4_of_l2 = 0.875;  ///< length of link 4, as a share of link 2's; a list may give l4 itself
  double needle_m = 0.1;
  double link3_rad = 1.5708;    ///< angle of link 3 to link 4 when the tip touches the sac
  double grip_N_per_m = 600.0;  ///< K_c of eq. (8)
  double skin_N_per_m = 300.0;
  double skin_punctures_at_N = 2.0;
  double skin_friction_N = 0.2;    ///< C_1 of eq. (3)
  double stick_N_per_m = 1000.0;   ///< K_l2 of eq. (4)
  double slips_at_N = 0.3;         ///< threshold of eq. (4)
  double damping_N_s_per_m = 5.0;  ///< D_l2 of eq. (5)
  double sac_N_per_m = 200.0;
  double sac_punctures_at_N = 1.0;
  double sac_friction_N = 0.1;  ///< C_3 of eq. (7)
  double sac_depth_m = 0.035;   ///< depth of the sac below the skin
};
[[nodiscard]] std::span<const Drawn<Plant>> plant_ranges() noexcept;

/// S4's three layers: skin, muscle by eq. (4) and (5) (BulkLaw::Window), sac. The skin is at y = 0.
[[nodiscard]] tissue::TissueSettings tissue_of(const Plant& plant);

/// Index of the sac among tissue_of()'s layers.
inline constexpr std::size_t kSac = 2;

}  // namespace telepalp::study
