#include "tools/study/task/plant.h"

namespace telepalp::study {
namespace {

constexpr Drawn<Plant> kPlantRanges[] = {
    {"l4, of l2", "", &Plant::l4_of_l2, 0.75, 1.0, "S4 does not give l4. With 0.867, its needle is parallel to link 4"},
    {"length of the needle", "m", &Plant::needle_m, 0.08, 0.15, "not in S4; usual needles"},
    {"angle of link 3 at the sac", "rad", &Plant::link3_rad, 1.42, 1.72, "not in S4: a right angle within 0.15 rad"},
    {"K_c of eq. (8)", "N/m", &Plant::grip_N_per_m, 300.0, 1000.0, "not in S4; what its device displays stably"},
    {"stiffness of the skin", "N/m", &Plant::skin_N_per_m, 150.0, 600.0, "not in S4"},
    {"skin is punctured at", "N", &Plant::skin_punctures_at_N, 1.0, 4.0,
     "not in S4; 18G perineum 8.9 N (Podder 2006), finer needles less"},
    {"C_1 of eq. (3)", "N", &Plant::skin_friction_N, 0.1, 0.4,
     "not in S4; shaft friction in liver 11 N for each metre inside"},
    {"K_l2 of eq. (4)", "N/m", &Plant::stick_N_per_m, 500.0, 1500.0, "de Jong and Dankelman 2017, liver: 1050 N/m"},
    {"threshold of eq. (4)", "N", &Plant::slips_at_N, 0.1, 0.5, "not in S4"},
    {"D_l2 of eq. (5)", "N s/m", &Plant::damping_N_s_per_m, 2.0, 10.0, "not in S4"},
    {"stiffness of the sac", "N/m", &Plant::sac_N_per_m, 80.0, 300.0,
     "113 N/m for a 22G needle in a membrane under 72 N/m (PMC4768058)"},
    {"sac is punctured at", "N", &Plant::sac_punctures_at_N, 0.1, 2.0, "no needle force on a human sac is published"},
    {"C_3 of eq. (7)", "N", &Plant::sac_friction_N, 0.02, 0.1, "not in S4"},
    {"depth of the sac", "m", &Plant::sac_depth_m, 0.025, 0.045, "not in S4"},
};

}  // namespace

std::span<const Drawn<Plant>> plant_ranges() noexcept { return kPlantRanges; }

tissue::TissueSettings tissue_of(const Plant& plant) {
  tissue::LayerSettings skin;
  skin.name = "skin";
  skin.surface = tissue::SurfaceSettings{.stiffness_N_per_m = plant.skin_N_per_m,
                                         .punctures_at_N = plant.skin_punctures_at_N,
                                         .friction_N = plant.skin_friction_N};
  tissue::LayerSettings muscle;
  muscle.name = "muscle";
  muscle.thickness_m = plant.sac_depth_m;
  muscle.bulk = tissue::BulkSettings{.law = tissue::BulkLaw::Window,
                                     .stick_N_per_m = plant.stick_N_per_m,
                                     .slips_at_N = plant.slips_at_N,
                                     .damping_N_s_per_m = plant.damping_N_s_per_m};
  tissue::LayerSettings sac;
  sac.name = "sac";
  sac.top_m = plant.sac_depth_m;
  sac.surface = tissue::SurfaceSettings{.stiffness_N_per_m = plant.sac_N_per_m,
                                        .punctures_at_N = plant.sac_punctures_at_N,
                                        .friction_N = plant.sac_friction_N};
  tissue::TissueSettings settings;
  settings.net_radius_m = 0.08;  // near a dead point, linkage 1 swings its needle far sideways
  settings.net_edge_m = 0.008;
  settings.layers = {skin, muscle, sac};
  return settings;
}

}  // namespace telepalp::study
