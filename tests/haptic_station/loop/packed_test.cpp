#include "haptic_station/loop/packed.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace telepalp::loop {
namespace {

double norm_of(const std::array<float, 3>& v) { return Eigen::Vector3d{v[0], v[1], v[2]}.norm(); }

TEST(Packed, AForceOnItsLimitIsNeverRecordedAboveIt) {
  std::mt19937 random(1);
  std::normal_distribution<double> component;
  int nearest_above = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Eigen::Vector3d force =
        9.999999999 * Eigen::Vector3d{component(random), component(random), component(random)}.normalized();
    if (norm_of(packed(force)) > 10.0) ++nearest_above;
    EXPECT_LE(norm_of(packed_towards_zero(force)), 10.0);
    EXPECT_NEAR(norm_of(packed_towards_zero(force)), 10.0, 2e-6);
  }
  EXPECT_GT(nearest_above, 0);  // otherwise rounding to nearest would suffice
}

TEST(Packed, ANaNIsRecordedAsNaN) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(packed_towards_zero({kNan, 0.0, 0.0})[0]));
}

}  // namespace
}  // namespace telepalp::loop
