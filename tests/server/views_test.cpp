// The messages for Foxglove, compared with telepalp's messages.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/asio/executor_work_guard.hpp>
#include <cstring>

#include "server/views/depth_views.h"
#include "server/views/station_views.h"
#include "server/views/view_maker.h"
#include "server/views/view_topics.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

DepthImage four_pixels(double unit_m) {
  return {.width = 2, .height = 2, .unit_m = unit_m, .samples = {1000, 0, 65535, 2000}};
}

std::vector<int> millimetres(const foxglove::RawImage& image) {
  std::vector<int> depths;
  for (std::size_t at = 0; at + 1 < image.data().size(); at += 2)
    depths.push_back(static_cast<unsigned char>(image.data()[at]) +
                     256 * static_cast<unsigned char>(image.data()[at + 1]));
  return depths;
}

TEST(DepthView, IsInMillimetresWhateverTheSensorsUnitAndZeroWhereSixteenBitsDoNotReach) {
  EXPECT_EQ(millimetres(views::depth_view(four_pixels(0.001), {})), (std::vector{1000, 0, 65535, 2000}));
  EXPECT_EQ(millimetres(views::depth_view(four_pixels(0.0001), {})), (std::vector{100, 0, 6554, 200}));
  EXPECT_EQ(millimetres(views::depth_view(four_pixels(0.002), {})), (std::vector{2000, 0, 0, 4000}));
}

TEST(CloudView, HoldsTheMeasuredPixelsWhereThePinholePutsThem) {
  const Intrinsics camera{.width = 2, .height = 2, .fx = 2.0, .fy = 4.0, .cx = 0.0, .cy = 1.0};
  const foxglove::PointCloud cloud = views::cloud_view(four_pixels(0.001), camera, session_time(1'500'000'000));
  ASSERT_EQ(cloud.data().size(), 3 * cloud.point_stride());
  float last[3];
  std::memcpy(last, cloud.data().data() + 2 * cloud.point_stride(), sizeof last);
  EXPECT_FLOAT_EQ(last[0], 1.0F);  // (1 - 0) / 2 * 2 m
  EXPECT_FLOAT_EQ(last[1], 0.0F);
  EXPECT_FLOAT_EQ(last[2], 2.0F);
  EXPECT_EQ(cloud.timestamp().seconds(), 1);
  EXPECT_EQ(cloud.timestamp().nanos(), 500'000'000);
}

TEST(CloudView, AnImageOfSixteenMegapixelsIsSubsampled) {
  DepthImage depth{.width = 4096, .height = 4096, .samples = std::vector<std::uint16_t>(4096 * 4096, 1000)};
  const Intrinsics camera{.width = 4096, .height = 4096, .fx = 1, .fy = 1, .cx = 0, .cy = 0};
  EXPECT_LE(views::cloud_view(depth, camera, {}).data().size(), wire::kMaxPayloadBytes);
}

TEST(UltrasoundView, IsTheImageOfAProbeOnTheSkinAlone) {
  msg::UltrasoundImage image;
  image.set_stamp_ns(1'500'000'000);
  EXPECT_FALSE(views::ultrasound_view(image)) << "the probe is in the air";
  image.set_on_skin(true);
  image.set_jpeg("picture");
  const auto view = views::ultrasound_view(image);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->format(), "jpeg");
  EXPECT_EQ(view->data(), "picture");
  EXPECT_EQ(view->timestamp().nanos(), 500'000'000);
}

msg::StationState touching() {
  msg::StationState state;
  state.set_stamp_ns(5);
  state.set_phase(msg::PHASE_IN_BODY);
  state.mutable_displayed_hand_camera()->set_z(0.7);
  state.mutable_proxy_camera()->set_z(0.71);
  state.mutable_force_camera_n()->set_y(-2.0);
  return state;
}

TEST(TransformsView, TheHandHasItsAttitudeUnlessItIsNoRotation) {
  msg::StationState state = touching();
  const auto hand_turn = [&] {
    const foxglove::FrameTransforms all = views::transforms_view(state, session_time(5));
    for (const foxglove::FrameTransform& one : all.transforms())
      if (one.child_frame_id() == "hand") return one.rotation();
    return foxglove::Quaternion();
  };
  EXPECT_EQ(hand_turn().w(), 1.0);
  state.mutable_hand_attitude_camera()->set_x(0.6);
  state.mutable_hand_attitude_camera()->set_w(0.8);
  EXPECT_NEAR(hand_turn().x(), 0.6, 1e-9);
  state.mutable_hand_attitude_camera()->set_z(7.0);
  EXPECT_EQ(hand_turn().w(), 1.0) << "a peer's numbers are not trusted";
}

TEST(HandView, IsTheDisplayedHandWithItsAttitudeAndNothingWithoutAHand) {
  msg::StationState state = touching();
  state.set_stamp_ns(3'000'000'007);
  state.mutable_displayed_hand_camera()->set_z(0.7);
  state.mutable_hand_attitude_camera()->set_x(0.6);
  state.mutable_hand_attitude_camera()->set_w(0.8);
  const std::optional<foxglove::PoseInFrame> hand = views::hand_view(state);
  ASSERT_TRUE(hand);
  EXPECT_EQ(hand->timestamp().seconds(), 3);
  EXPECT_EQ(hand->timestamp().nanos(), 7);
  EXPECT_NEAR(hand->pose().position().z(), 0.7, 1e-12);
  EXPECT_NEAR(hand->pose().orientation().x(), 0.6, 1e-9);
  state.clear_displayed_hand_camera();
  EXPECT_FALSE(views::hand_view(state)) << "no hand is never a hand at the origin";
}

TEST(SceneView, TheArrowPointsAlongTheForceAndIsAsLongAsItIsStrong) {
  const foxglove::SceneUpdate scene = views::scene_view(touching());
  for (const foxglove::SceneEntity& entity : scene.entities())
    if (entity.id() == "force") {
      const foxglove::ArrowPrimitive& arrow = entity.arrows(0);
      const auto& turned = arrow.pose().orientation();
      const Eigen::Quaterniond rotation(turned.w(), turned.x(), turned.y(), turned.z());
      EXPECT_LT((rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d(0, -1, 0)).norm(), 1e-9);
      EXPECT_NEAR(arrow.shaft_length() + arrow.head_length(), 0.04, 1e-9);
      return;
    }
  FAIL() << "no arrow";
}

TEST(SceneView, TheDrivesForceHasNoArrowOfContact) {
  msg::StationState state = touching();
  state.set_phase(msg::PHASE_OUT_BODY);
  const foxglove::SceneUpdate scene = views::scene_view(state);
  for (const foxglove::SceneEntity& entity : scene.entities()) EXPECT_NE(entity.id(), "force");
  ASSERT_EQ(scene.deletions_size(), 3)
      << "device and phase, whose place is not known, and the arrow of the contact before";
  EXPECT_EQ(scene.deletions(1).id(), "force");
}

/// The entity `id` of the scene; an empty one, if it has none.
foxglove::SceneEntity entity_of(const foxglove::SceneUpdate& scene, const std::string& id) {
  for (const foxglove::SceneEntity& entity : scene.entities())
    if (entity.id() == id) return entity;
  return {};
}

TEST(SceneView, TheDevicesBallHasItsTrueSize) {
  msg::StationState state = touching();
  state.mutable_device_camera()->set_z(0.72);
  const foxglove::SceneEntity device = entity_of(views::scene_view(state), "device");
  ASSERT_EQ(device.spheres_size(), 1);
  EXPECT_NEAR(device.spheres(0).size().x(), 0.06, 1e-9);
}

TEST(SceneView, NamesThePhaseInADoctorsWords) {
  msg::StationState state = touching();
  state.mutable_device_camera()->set_z(0.72);
  state.set_phase(msg::PHASE_CYLINDER_LATERAL);
  const foxglove::SceneEntity phase = entity_of(views::scene_view(state), "phase");
  ASSERT_EQ(phase.texts_size(), 1);
  EXPECT_EQ(phase.texts(0).text(), "Side of an inner object");
}

TEST(SceneView, RemovesWhatTheStationDoesNotReport) {
  const foxglove::SceneUpdate scene = views::scene_view(msg::StationState());
  EXPECT_EQ(scene.entities_size(), 0);
  EXPECT_EQ(scene.deletions_size(), 5);
}

TEST(ViewMaker, DecodesNothingUntilSomebodyLooksAndNothingAfterwards) {
  boost::asio::io_context io;
  const auto stay = boost::asio::make_work_guard(io);
  hub::Hub source;
  hub::Hub views;
  views::ViewMaker maker(io, source, views);
  codec::DepthEncoder encoder({});
  const auto publish = [&] {
    msg::DepthImage image;
    image.set_data(encoder.encode(four_pixels(0.001)).bytes);
    source.publish(wire::make_message(wire::kCameraDepth, session_time(1), image));
    for (int tries = 0; tries < 20; ++tries) io.run_one_for(5ms);
  };
  const hub::SubscriberId viewer = views.join("viewer", "", [] {});
  maker.subscriptions_changed();
  publish();
  EXPECT_EQ(maker.decoded(), 0u);
  EXPECT_TRUE(source.subscriber_counts().empty());

  views.subscribe(viewer, {std::string(views::kDepthView.name)});
  maker.subscriptions_changed();
  publish();
  EXPECT_EQ(maker.decoded(), 1u);
  EXPECT_EQ(source.subscriber_counts().size(), 1u);
  ASSERT_TRUE(views.next(viewer));

  views.leave(viewer);
  maker.subscriptions_changed();
  publish();
  EXPECT_EQ(maker.decoded(), 1u);
  EXPECT_TRUE(source.subscriber_counts().empty());
}

TEST(ViewMaker, DepthThatCannotBeReadMakesNothingAndAsksForAKeyFrame) {
  boost::asio::io_context io;
  const auto stay = boost::asio::make_work_guard(io);
  hub::Hub source;
  hub::Hub views;
  int asked = 0;
  source.on_key_frame_request([&](std::string_view) { ++asked; });
  views::ViewMaker maker(io, source, views);
  const hub::SubscriberId viewer = views.join("viewer", "", [] {});
  views.subscribe(viewer, {std::string(views::kDepthView.name)});
  maker.subscriptions_changed();
  wire::Message damaged{wire::kCameraDepth, session_time(2), std::make_shared<const std::string>("\xff\xff")};
  source.publish(damaged);
  damaged.key_frame = false;
  damaged.published = session_time(3);
  source.publish(damaged);
  for (int tries = 0; tries < 40; ++tries) io.run_one_for(5ms);
  EXPECT_EQ(maker.decoded(), 0u);
  EXPECT_FALSE(views.next(viewer));
  EXPECT_GT(asked, 0);
}

}  // namespace
}  // namespace telepalp::server
