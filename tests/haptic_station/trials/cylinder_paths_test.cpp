#include "haptic_station/trials/cylinder_paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace telepalp::trials {
namespace {

/// A press straight down on the object, whose end-effector trembles sideways by a micrometre.
TrialResult straight_press() {
  TrialResult result;
  for (int i = 0; i < 100; ++i) {
    TrialSample sample{};
    sample.phase = control::Phase::ObjectUpper;
    sample.device.m = {1e-6 * (i % 2), -0.03 - 1e-5 * i, 0.0};
    sample.force.N = {0.0, 5.0, 0.0};
    result.samples.push_back(sample);
  }
  return result;
}

double span(const plot::Range& range) { return std::abs(range.most - range.least); }

}  // namespace

TEST(CylinderPaths, AMillimetreIsAsLongAlongXAsAlongY) {
  const plot::Chart chart = cylinder_paths(straight_press());
  ASSERT_TRUE(chart.x.include && chart.y.include);
  const plot::Frame frame = plot::frame_of(chart);
  EXPECT_NEAR(span(*chart.x.include) / span(frame.x_px), span(*chart.y.include) / span(frame.y_px), 1e-9);
  EXPECT_GT(span(*chart.x.include), 10.0) << "a tremor must not fill the width";
}

TEST(CylinderPaths, WithoutAPressOnAnObjectTheChartIsEmpty) { EXPECT_TRUE(cylinder_paths({}).series.empty()); }

}  // namespace telepalp::trials
