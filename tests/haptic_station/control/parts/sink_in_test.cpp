#include "haptic_station/control/parts/sink_in.h"

#include <gtest/gtest.h>

namespace telepalp::control {
namespace {

constexpr double kTick_s = 0.0005;

ports::SurfaceContact at_depth(double depth_m) {
  ports::SurfaceContact contact;
  contact.valid = contact.in_body = true;
  contact.normal.v = Eigen::Vector3d::UnitY();
  contact.distance_m = -depth_m;
  return contact;
}

TEST(SinkIn, ShowsTheSkinAtTheDeviceFirstAndWhereItIsLater) {
  SinkIn sink_in;
  sink_in.begin(0.02);
  sink_in.step(kTick_s);
  EXPECT_NEAR(sink_in.shown(at_depth(0.02)).distance_m, 0.0, 3e-5);
  double fastest = 0.0;
  for (int tick = 0; tick < 4000; ++tick) {
    sink_in.step(kTick_s);
    fastest = std::max(fastest, sink_in.shown(at_depth(0.02)).surface_speed_m_per_s);
  }
  EXPECT_DOUBLE_EQ(fastest, 0.05) << "it rises, and slowly";
  EXPECT_EQ(sink_in.shown(at_depth(0.02)).distance_m, -0.02);
  EXPECT_EQ(sink_in.shown(at_depth(0.02)).surface_speed_m_per_s, 0.0);
}

TEST(SinkIn, IsNothingForAContactThatBeginsAtTheSkin) {
  SinkIn sink_in;
  sink_in.begin(-0.001);
  sink_in.step(kTick_s);
  EXPECT_EQ(sink_in.shown(at_depth(0.01)).distance_m, -0.01);
}

TEST(SinkIn, TheEffectsSeeADeviceThatIsAsDeepAsTheHandFeels) {
  SinkIn sink_in;
  sink_in.begin(0.02);
  sink_in.step(kTick_s);
  const ports::SurfaceContact shown = sink_in.shown(at_depth(0.02));
  const effects::EffectInput felt = sink_in.in_body_frame({{0.0, -0.02, 0.0}}, {}, shown);
  EXPECT_NEAR(felt.device.m.y(), shown.distance_m, 1e-15) << "in a body whose skin is at 0";
  EXPECT_NEAR(felt.contact.proxy.m.y(), 0.0, 1e-15);
  EXPECT_NEAR(felt.device_velocity.v.y(), -shown.surface_speed_m_per_s, 1e-15);
}

/// The support grows when the skin comes back into sight. Measured from the true skin, the indentation would grow by a
/// share of the whole depth, and the hand would get energy.
TEST(SinkIn, ASupportThatGrowsOverADeepHandDoesNotIndentTheSkin) {
  constexpr double kDepth_m = 0.14;
  SinkIn sink_in;
  sink_in.begin(kDepth_m);
  for (const double support : {0.2, 0.9, 0.95, 1.0}) {
    ports::SurfaceContact contact = at_depth(kDepth_m);
    contact.support = support;
    contact.proxy.m.y() = -(1.0 - support) * kDepth_m;
    const Point<HapticBase> device{{0.0, -kDepth_m, 0.0}};
    const effects::EffectInput felt = sink_in.in_body_frame(device, {}, sink_in.shown(contact));
    EXPECT_NEAR(felt.device.m.y() - felt.contact.proxy.m.y(), 0.0, 1e-12) << support;
  }
}

}  // namespace
}  // namespace telepalp::control
