#include "haptic_station/surface/build/body_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace telepalp::surface {
namespace {

TEST(BodyMotion, FindsRiseAndTiltBesideAnObjectOnAThirdOfTheImage) {
  const BlockLattice lattice = blocks_of(160, 120);
  std::vector<float> before_m(lattice.size(), 0.8F);
  std::vector<float> seen_m(lattice.size());
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column) {
      const double rise_m = 0.004 + 0.0002 * (column - 0.5 * (lattice.columns - 1));
      const double object_m = column > 2 * lattice.columns / 3 ? 0.06 : 0.0;
      seen_m[lattice.at(column, row)] = static_cast<float>(0.8 - rise_m - object_m);
    }
  const BodyMotion motion = body_motion(lattice, before_m, seen_m);
  EXPECT_NEAR(motion.at(0, lattice.rows / 2), 0.004 - 0.0001 * (lattice.columns - 1), 1e-3);
  EXPECT_LT(motion.off_m, 0.001);
}

TEST(BodyMotion, NothingThatBothImagesShowIsNoPerfectFit) {
  const BlockLattice lattice = blocks_of(160, 120);
  const std::vector<float> unknown(lattice.size(), 0.0F);
  const std::vector<float> seen_m(lattice.size(), 0.8F);
  EXPECT_TRUE(std::isinf(body_motion(lattice, unknown, seen_m).off_m));
}

}  // namespace
}  // namespace telepalp::surface
