// The probe that the hand holds, and the messages about what lies inside the body.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "codec/color.h"
#include "haptic_station/core/inside/inner_surfaces.h"
#include "haptic_station/core/inside/ultrasound_image.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/polish.h"
#include "haptic_station/station/rigs/scene_rig.h"
#include "proto/wire/inside/inside_message.h"

namespace telepalp::core {
namespace {

using Eigen::Vector3d;

/// A camera that looks straight down on H: its x is H's x, its depth runs along -y of H.
Transform<HapticBase, DepthCamera> camera_above() {
  Transform<HapticBase, DepthCamera> haptic_from_camera;
  haptic_from_camera.iso.linear() = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3d::UnitX()).toRotationMatrix();
  haptic_from_camera.iso.translation() = Vector3d(0.0, 0.8, 0.0);
  return haptic_from_camera;
}

loop::TickSample pressed() {
  loop::TickSample tick;
  tick.in_body = true;
  tick.proxy = {0.02F, 0.0F, 0.05F};
  tick.normal = {0.0F, 1.0F, 0.0F};
  return tick;
}

/// The attitude of a hand, given in H, as a tick states it in K.
std::array<float, 4> in_camera(const Eigen::Quaterniond& in_haptic) {
  const Eigen::Quaterniond q(camera_above().iso.linear().transpose() * in_haptic.toRotationMatrix());
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()), static_cast<float>(q.w())};
}

/// Palm down with the fingers towards the head: x to the patient's left, y to the head (-z), z up.
Eigen::Quaterniond palm_down() {
  return Eigen::Quaterniond(Eigen::AngleAxisd(-std::numbers::pi / 2.0, Vector3d::UnitX()));
}

TEST(HeldProbe, WithoutAnAttitudeItStandsUprightOnTheSkin) {
  loop::TickSample tick = pressed();
  const Vector3d normal = Vector3d(0.3, 1.0, 0.0).normalized();
  tick.normal = {static_cast<float>(normal.x()), static_cast<float>(normal.y()), 0.0F};
  const HeldProbe probe = held_probe(tick, camera_above());
  ASSERT_TRUE(probe.on_skin);
  EXPECT_LT((probe.pose.into_body + normal).norm(), 1e-6);
  EXPECT_LT(std::abs(probe.pose.across.dot(normal)), 1e-6);
  EXPECT_GT(probe.pose.across.x(), 0.9) << "the image's left is the picture's left";
  EXPECT_LT((probe.pose.at - Vector3d(0.02, 0.0, 0.05)).norm(), 1e-6);
}

TEST(HeldProbe, ItsFaceLooksOutOfThePalmAndItsLongSideLiesAcrossTheHand) {
  loop::TickSample tick = pressed();
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.5, Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(0.3, Vector3d::UnitZ()) * palm_down());
  tick.hand_attitude_camera = in_camera(turned);
  const HeldProbe probe = held_probe(tick, camera_above());
  ASSERT_TRUE(probe.on_skin);
  EXPECT_LT((probe.pose.into_body - turned * Vector3d(0, 0, -1)).norm(), 1e-5);
  EXPECT_LT((probe.pose.across - turned * Vector3d::UnitX()).norm(), 1e-5);
}

TEST(HeldProbe, OneThatIsInTheAirOrTurnedAwayIsNotOnTheSkin) {
  loop::TickSample tick = pressed();
  tick.in_body = false;
  EXPECT_FALSE(held_probe(tick, camera_above()).on_skin);
  tick = pressed();
  tick.contact_unknown = true;
  EXPECT_FALSE(held_probe(tick, camera_above()).on_skin);
  for (const double turned_deg : {50.0, 70.0, 180.0}) {
    tick = pressed();
    tick.hand_attitude_camera = in_camera(
        Eigen::Quaterniond(Eigen::AngleAxisd(turned_deg * std::numbers::pi / 180.0, Vector3d::UnitX()) * palm_down()));
    EXPECT_EQ(held_probe(tick, camera_above()).on_skin, turned_deg < 60.0) << turned_deg;
  }
}

/// The attitudes that the tracker of a scene's simulated hand reports in 20 s, in H.
std::vector<std::optional<Eigen::Quaterniond>> attitudes_of(const scenes::Scene& scene) {
  std::vector<std::optional<Eigen::Quaterniond>> attitudes;
  const auto rig = station::rig_of(scene, std::nullopt);
  for (int tick = 0; tick < 40'000; ++tick) {
    if (const auto sample = rig->hand(SessionTime{std::chrono::microseconds{500 * tick}}))
      attitudes.push_back(sample->attitude);
    rig->apply({{Vector3d::Zero()}}, {}, 5e-4);
  }
  return attitudes;
}

TEST(SimulatedRig, ItsWristTiltsAProbeThatStaysOnTheSkin) {
  scenes::Scene scene;
  EXPECT_EQ(attitudes_of(scene).front(), std::nullopt) << "a hand without a probe";
  scene.probe = scenes::Probe{};
  const auto attitudes = attitudes_of(scene);
  ASSERT_GT(attitudes.size(), 1500U);
  double most_deg = 0.0;
  for (const auto& attitude : attitudes) {
    ASSERT_TRUE(attitude);
    loop::TickSample tick = pressed();
    tick.hand_attitude_camera = in_camera(*attitude);
    const HeldProbe probe = held_probe(tick, camera_above());
    EXPECT_TRUE(probe.on_skin);
    most_deg = std::max(most_deg, std::acos(-probe.pose.into_body.y()) * 180.0 / std::numbers::pi);
  }
  EXPECT_GT(most_deg, 14.0) << "it fans by 15 degrees and rocks by 8";
  EXPECT_LT(most_deg, 18.0);
}

std::shared_ptr<const effects::SolidLayer> layer(const std::string& polish) {
  return std::make_shared<const effects::SolidLayer>(
      effects::SolidLayer{"layer", *solids::build_tree(*solids::parse_polish(polish, "test")), {}});
}

std::uint32_t u16(const std::string& bytes, std::size_t i) {
  return static_cast<std::uint8_t>(bytes[2 * i]) + 256U * static_cast<std::uint8_t>(bytes[2 * i + 1]);
}

TEST(InnerStructures, LieOnTheLayersAndFitTheirMessage) {
  const std::vector<InnerLayer> layers{{layer("tr 0.02 -0.05 0.01 sphere 0.03"), 1},
                                       {layer("+ torusz 0.1 0.008 tr 0 -0.1 0 torusx 0.08 0.005"), 3}};
  const InnerSurfaces surfaces = *inner_structures(layers);
  EXPECT_TRUE(surfaces.left_out.empty());
  msg::InnerStructures inside = surfaces.drawn;
  ASSERT_EQ(inside.structures_size(), 2);
  set_place(inside, camera_above());
  EXPECT_TRUE(wire::is_valid(inside));
  EXPECT_LT(inside.ByteSizeLong(), std::size_t{1} << 20);
  for (int i = 0; i < 2; ++i) {
    const msg::InnerStructure& structure = inside.structures(i);
    EXPECT_EQ(structure.effect(), layers[static_cast<std::size_t>(i)].effect);
    EXPECT_GT(structure.triangles().size(), 6U * 1000U);
    double furthest_m = 0.0;
    for (std::size_t at = 0; at < structure.points().size() / 6; ++at) {
      const Vector3d point =
          Vector3d(structure.least().x(), structure.least().y(), structure.least().z()) +
          structure.step_m() * Vector3d(u16(structure.points(), 3 * at), u16(structure.points(), 3 * at + 1),
                                        u16(structure.points(), 3 * at + 2));
      furthest_m =
          std::max(furthest_m, std::abs(solids::solid_at(*layers[static_cast<std::size_t>(i)].solid->tree, point).m));
    }
    EXPECT_LT(furthest_m, 20e-6) << "the points are moved onto the surface";
  }
}

TEST(InnerStructures, ALayerWithoutBoundsIsLeftOutAndNamed) {
  const std::vector<InnerLayer> layers{{layer("plane 0 1 0 -0.05"), 0}, {layer("sphere 0.03"), 1}};
  const InnerSurfaces inside = *inner_structures(layers);
  ASSERT_EQ(inside.drawn.structures_size(), 1);
  EXPECT_EQ(inside.drawn.structures(0).effect(), 1U);
  ASSERT_EQ(inside.left_out.size(), 1U);
  EXPECT_NE(inside.left_out.front().find("layer layer: "), std::string::npos) << inside.left_out.front();
  EXPECT_NE(inside.left_out.front().find("extends without end"), std::string::npos) << inside.left_out.front();
}

TEST(UltrasoundMessage, HoldsTheImageAndThePoseInTheCamerasFrame) {
  const ultrasound::BModeSettings settings;
  const HeldProbe probe = held_probe(pressed(), camera_above());
  msg::UltrasoundImage message = probe_message(probe, settings, camera_above());
  EXPECT_FALSE(message.on_skin()) << "no image yet";
  const std::vector<std::shared_ptr<const effects::SolidLayer>> layers{layer("tr 0.02 -0.03 0.05 sphere 0.01")};
  const ultrasound::BModeImage image = ultrasound::b_mode(layers, probe.pose, settings);
  set_image(message, image);
  EXPECT_TRUE(wire::is_valid(message));
  EXPECT_NEAR(message.face_camera().x(), 0.02, 1e-6);
  EXPECT_NEAR(message.face_camera().z(), 0.8, 1e-6);
  EXPECT_NEAR(message.into_body_camera().z(), 1.0, 1e-6) << "away from a camera above";
  const auto seen = codec::decode_color(std::as_bytes(std::span(message.jpeg())));
  ASSERT_TRUE(seen.ok());
  double sum = 0.0;
  for (std::size_t i = 0; i < image.gray.size(); ++i) sum += std::abs(int{seen->rgb[3 * i]} - int{image.gray[i]});
  EXPECT_LT(sum / static_cast<double>(image.gray.size()), 12.0) << "mean difference of grey levels, of speckle";
}

TEST(UltrasoundMessage, OfAProbeInTheAirIsValidAndEmpty) {
  const msg::UltrasoundImage message = probe_message({}, {}, camera_above());
  EXPECT_TRUE(wire::is_valid(message));
  EXPECT_TRUE(message.jpeg().empty());
}

}  // namespace
}  // namespace telepalp::core
