#include "haptic_station/control/parts/sink_in.h"

#include <gtest/gtest.h>

#include "tests/haptic_station/periods.h"

namespace telepalp::control {
namespace {

ports::SurfaceContact at_depth(double depth_m) {
  ports::SurfaceContact contact;
  contact.valid = contact.in_body = true;
  contact.normal.v = Eigen::Vector3d::UnitY();
  contact.distance_m = -depth_m;
  return contact;
}

TEST(SinkIn, ShowsTheSkinAtTheDeviceFirstAndWhereItIsLater) {
  SinkIn sink_in;
  sink_in.begin(at_depth(0.02));
  sink_in.step(at_depth(0.02), kTick_s);
  EXPECT_NEAR(sink_in.shown(at_depth(0.02)).distance_m, 0.0, 6e-5);
  double fastest = 0.0;
  for (int tick = 0; tick < 4000; ++tick) {
    sink_in.step(at_depth(0.02), kTick_s);
    fastest = std::max(fastest, sink_in.shown(at_depth(0.02)).surface_speed_m_per_s);
  }
  EXPECT_DOUBLE_EQ(fastest, 0.1) << "it rises, and slowly";
  EXPECT_EQ(sink_in.shown(at_depth(0.02)).distance_m, -0.02);
  EXPECT_EQ(sink_in.shown(at_depth(0.02)).surface_speed_m_per_s, 0.0);
}

/// The end-effector springs back by 40 mm, and the lowered body follows. Where the body gives no force, it may rise
/// fast; when it meets the end-effector, it must rise as slowly as in a contact.
TEST(SinkIn, RisesFasterInAGapAndMeetsTheEndEffectorSlowly) {
  SinkIn sink_in;
  sink_in.begin(at_depth(0.06));
  double fastest_m_per_s = 0.0;
  double rises_for_s = 0.0;
  while (sink_in.shown(at_depth(0.02)).distance_m > 0.0) {
    ASSERT_LT(rises_for_s += kTick_s, 0.4) << "100 mm/s would take 0.4 s";
    sink_in.step(at_depth(0.02), kTick_s);
    fastest_m_per_s = std::max(fastest_m_per_s, sink_in.shown(at_depth(0.02)).surface_speed_m_per_s);
  }
  EXPECT_DOUBLE_EQ(fastest_m_per_s, 0.15);
  EXPECT_LT(rises_for_s, 0.3);
  EXPECT_DOUBLE_EQ(sink_in.shown(at_depth(0.02)).surface_speed_m_per_s, 0.1);
}

/// The displayed surface itself still rises towards the measured one, faster than a contact allows at first.
TEST(SinkIn, BodyAndDisplayedSurfaceTogetherRiseAtMostAtATenthOfAMetreASecond) {
  SinkIn sink_in;
  ports::SurfaceContact contact = at_depth(0.02);
  sink_in.begin(contact);
  for (const double surface_m_per_s : {0.15, 0.1, 0.05}) {
    contact.surface_speed_m_per_s = surface_m_per_s;
    sink_in.step(contact, kTick_s);
    EXPECT_NEAR(sink_in.shown(contact).surface_speed_m_per_s, 0.1, 1e-12) << surface_m_per_s;
  }
}

TEST(SinkIn, IsNothingForAContactThatBeginsAtTheSkin) {
  SinkIn sink_in;
  sink_in.begin(at_depth(-0.001));
  sink_in.step(at_depth(0.01), kTick_s);
  EXPECT_EQ(sink_in.shown(at_depth(0.01)).distance_m, -0.01);
}

TEST(SinkIn, TheEffectsSeeADeviceThatIsAsDeepAsTheHandFeels) {
  SinkIn sink_in;
  sink_in.begin(at_depth(0.02));
  sink_in.step(at_depth(0.02), kTick_s);
  const ports::SurfaceContact shown = sink_in.shown(at_depth(0.02));
  const effects::EffectInput felt = sink_in.in_body_frame({{0.0, -0.02, 0.0}}, {}, shown);
  EXPECT_NEAR(felt.device.m.y(), shown.distance_m, 1e-15) << "in a body whose skin is at 0";
  EXPECT_NEAR(felt.contact.proxy.m.y(), 0.0, 1e-15);
  EXPECT_NEAR(felt.device_velocity.v.y(), -shown.surface_speed_m_per_s, 1e-15);
}

/// The coverage grows when the skin comes back into sight. Measured from the true skin, the indentation would grow by a
/// share of the whole depth, and the hand would get energy.
TEST(SinkIn, ASupportThatGrowsOverADeepHandDoesNotIndentTheSkin) {
  constexpr double kDepth_m = 0.14;
  SinkIn sink_in;
  sink_in.begin(at_depth(kDepth_m));
  for (const double coverage : {0.2, 0.9, 0.95, 1.0}) {
    ports::SurfaceContact contact = at_depth(kDepth_m);
    contact.coverage = coverage;
    contact.proxy.m.y() = -(1.0 - coverage) * kDepth_m;
    const Point<HapticBase> device{{0.0, -kDepth_m, 0.0}};
    const effects::EffectInput felt = sink_in.in_body_frame(device, {}, sink_in.shown(contact));
    EXPECT_NEAR(felt.device.m.y() - felt.contact.proxy.m.y(), 0.0, 1e-12) << coverage;
  }
}

/// The camera sees the skin again, over a hand that went to 80 mm deep while the skin was hidden. The coverage grows at
/// its greatest rate, 2 per second.
TEST(SinkIn, ASupportThatGrowsInAContactDoesNotStiffenTheSkin) {
  SinkIn sink_in;
  sink_in.begin(at_depth(0.0));
  ports::SurfaceContact contact = at_depth(0.08);
  contact.coverage = 0.2;
  sink_in.step(contact, kTick_s);
  EXPECT_EQ(sink_in.shown(contact).distance_m, -0.08);
  while (contact.coverage < 1.0) {
    const double before_m = contact.coverage * sink_in.shown(contact).distance_m;
    contact.coverage = std::min(1.0, contact.coverage + 2.0 * kTick_s);
    sink_in.step(contact, kTick_s);
    ASSERT_GE(contact.coverage * sink_in.shown(contact).distance_m, before_m - 0.1 * kTick_s)
        << "the spring is compressed only by the body's rise";
  }
  for (int tick = 0; tick < 4000; ++tick) sink_in.step(contact, kTick_s);
  EXPECT_EQ(sink_in.shown(contact).distance_m, -0.08) << "the body has returned to its true place";
}

}  // namespace
}  // namespace telepalp::control
