#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "haptic_station/surface/foresight/recent_way.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/temporal/straight_motion.h"
#include "tests/haptic_station/periods.h"

// The three bounds of a sudden motion's prediction: way, drop and (in shared_motion_test.cpp) regression.

namespace telepalp::surface {
namespace {

/// Distance that a body at `speed_m_per_s` is predicted to go in all.
double goes_m(double speed_m_per_s, double freeze_from_s) {
  MotionModel model;
  model.moves = true;
  model.breathing_rad_per_s = 1e-3;
  model.linear_fade_s = 1e3;
  model.freeze_from_s = freeze_from_s;
  return speed_m_per_s * static_cast<double>(motion_basis(model, 10.0).value[0]);
}

TEST(Way, APredictionGoesAtMostAsFarAsTheSkinWentInTheLastHalfSecond) {
  for (const double speed : {0.01, 0.05, 0.2})
    for (const double way_m : {0.001, 0.005, 0.01}) {
      const double freeze_from_s = freeze_within(way_m, speed, 0.6);
      EXPECT_LT(goes_m(speed, freeze_from_s), 1.0001 * way_m) << speed << " m/s after " << way_m << " m";
    }
}

TEST(Way, ASlowMotionAfterALongWayIsPredictedForAsLongAsAnyOther) { EXPECT_EQ(freeze_within(0.01, 0.001, 0.6), 0.6); }

TEST(Way, TheWayIsForgottenAfterHalfASecondAtRest) {
  RecentWay way;
  const std::vector<float> counts{1.0F, 0.0F};
  for (const float at_m : {0.0F, 0.005F, 0.01F}) way.add(std::vector<float>{at_m, 9.0F}, counts, kFrame_s);
  EXPECT_NEAR(way.m(), 0.01, 1e-6);
  for (int n = 0; n < 17; ++n) way.add(std::vector<float>{0.01F, 0.0F}, counts, kFrame_s);
  EXPECT_EQ(way.m(), 0.0);
}

TEST(Way, ABodyThatComesBackHasGoneTheWayToItsFarthestPlace) {
  RecentWay way;
  const std::vector<float> counts{1.0F};
  for (const float at_m : {0.0F, 0.004F, 0.001F}) way.add(std::vector<float>{at_m}, counts, kFrame_s);
  EXPECT_NEAR(way.m(), 0.003, 1e-6);
}

/// The cells of a level body that follows `moved_m(t)`, without noise.
class Body {
 public:
  void follow(const std::function<double(double)>& moved_m, double until_s) {
    for (; t_ < until_s; t_ += kFrame_s) {
      motion.predict(kFrame_s);
      const auto at_m = static_cast<float>(moved_m(t_));
      const std::vector<float> level(lattice_.size(), at_m);
      motion.correct(std::vector<CellInnovation>(lattice_.size(), {0.0, 256.0, 1e-4}), level, kFrame_s);
      motion.measure(level, kFrame_s);
    }
  }
  [[nodiscard]] double velocity_m_per_s() const { return motion.velocity_m_per_s(lattice_.size() / 2); }

 private:
  CellLattice lattice_ = lattice_of(160, 160);
  double t_ = 0.0;

 public:
  StraightMotion motion{lattice_};
};

double shift_m(double t) { return 0.05 * std::clamp(t - 1.0, 0.0, 0.3); }

TEST(Drop, ABodyThatMovesOnIsFollowedAtItsSpeed) {
  Body body;
  body.follow(shift_m, 1.29);
  EXPECT_NEAR(body.velocity_m_per_s(), 0.045, 0.01);
}

TEST(Drop, OneFrameAfterTheMotionEndsTheStraightPredictionEndsToo) {
  Body body;
  body.follow(shift_m, 1.4);
  EXPECT_LE(std::abs(body.velocity_m_per_s()), StraightMotion::kMeasuredMargin_m_per_s);
}

TEST(Drop, AStraightPredictionAgainstTheMeasuredMotionEnds) {
  Body body;
  body.follow([](double t) { return shift_m(t) - 0.2 * std::max(0.0, t - 1.3); }, 1.335);
  EXPECT_LE(body.velocity_m_per_s(), StraightMotion::kMeasuredMargin_m_per_s);
}

}  // namespace
}  // namespace telepalp::surface
