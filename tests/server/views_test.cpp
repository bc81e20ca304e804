// The messages for Foxglove, compared with telepalp's messages.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/asio/executor_work_guard.hpp>
#include <cstring>

#include "codec/color.h"
#include "foxglove/CameraCalibration.pb.h"
#include "messages/camera.pb.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/vector_message.h"
#include "server/views/depth_views.h"
#include "server/views/inside_views.h"
#include "server/views/station_views.h"
#include "server/views/view_maker.h"
#include "server/views/view_topics.h"

namespace telepalp::server {
namespace {

using namespace std::chrono_literals;

DepthImage four_pixels(double unit_m) {
  return {.width = 2, .height = 2, .unit_m = unit_m, .samples = {1000, 0, 65535, 2000}};
}

RgbdFrame four_pixel_frame() {
  RgbdFrame frame;
  frame.captured = session_time(1'500'000'000);
  frame.depth = four_pixels(0.001);
  frame.camera.depth = {.width = 2, .height = 2, .fx = 2.0, .fy = 4.0, .cx = 0.0, .cy = 1.0};
  return frame;
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
  const foxglove::PointCloud cloud = views::cloud_view(four_pixel_frame());
  EXPECT_EQ(cloud.fields_size(), 3) << "without colour";
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
  RgbdFrame frame;
  frame.depth = {.width = 4096, .height = 4096, .samples = std::vector<std::uint16_t>(4096 * 4096, 1000)};
  frame.color = {.width = 4096, .height = 4096, .rgb = std::vector<std::uint8_t>(3 * 4096 * 4096)};
  frame.camera.depth = {.width = 4096, .height = 4096, .fx = 1, .fy = 1, .cx = 0, .cy = 0};
  EXPECT_LE(views::cloud_view(frame).data().size(), wire::kMaxPayloadBytes);
}

/// The colour of point `number`, as Foxglove reads it from the fields red, green, blue and alpha.
std::vector<int> color_of(const foxglove::PointCloud& cloud, std::size_t number) {
  std::vector<int> rgba;
  for (const char* name : {"red", "green", "blue", "alpha"})
    for (const foxglove::PackedElementField& field : cloud.fields())
      if (field.name() == name && field.type() == foxglove::PackedElementField::UINT8)
        rgba.push_back(static_cast<unsigned char>(cloud.data()[number * cloud.point_stride() + field.offset()]));
  return rgba;
}

TEST(CloudView, APointHasTheColourOfItsPixelThatIsRegisteredOrProjected) {
  RgbdFrame frame = four_pixel_frame();
  frame.color = {.width = 2, .height = 2, .rgb = {10, 11, 12, 20, 21, 22, 30, 31, 32, 40, 41, 42}};
  EXPECT_EQ(color_of(views::cloud_view(frame), 0), (std::vector{10, 11, 12, 255}));
  EXPECT_EQ(color_of(views::cloud_view(frame), 2), (std::vector{40, 41, 42, 255}));
  frame.camera.color = frame.camera.depth;
  frame.camera.color.cx += 1.0;  // the colour camera sees everything one pixel further to the right
  frame.camera.color_registered = false;
  EXPECT_EQ(color_of(views::cloud_view(frame), 0), (std::vector{20, 21, 22, 255}));
}

msg::InnerStructures two_layers() {
  msg::InnerStructures inside;
  inside.mutable_haptic_origin_camera()->set_z(0.8);
  inside.mutable_camera_from_haptic()->set_x(1.0);  // half a turn about x
  for (const std::uint32_t effect : {2U, 5U}) {
    msg::InnerStructure& structure = *inside.add_structures();
    structure.set_name("ribs");
    structure.set_effect(effect);
    structure.mutable_least()->set_x(0.25);
    structure.set_step_m(0.0001);
    structure.set_points(
        std::string("\x00\x00\x01\x00\x00\x01"
                    "\x02\x00\x00\x00\x00\x00"
                    "\x00\x00\x00\x00\x03\x00",
                    18));
    structure.set_triangles(std::string("\x00\x00\x01\x00\x02\x00", 6));
  }
  return inside;
}

TEST(InsideView, EachLayerIsItsTrianglesInAFrameThatMovesWithIt) {
  const foxglove::SceneUpdate scene = views::inside_view(two_layers());
  ASSERT_EQ(scene.entities_size(), 2);
  const foxglove::SceneEntity& layer = scene.entities(1);
  EXPECT_TRUE(layer.frame_locked());
  EXPECT_FALSE(layer.has_lifetime()) << "the message comes once";
  const foxglove::TriangleListPrimitive& mesh = layer.triangles(0);
  ASSERT_EQ(mesh.points_size(), 3);
  EXPECT_NEAR(mesh.points(0).x(), 0.25, 1e-12);
  EXPECT_NEAR(mesh.points(0).y(), 0.0001, 1e-12);
  EXPECT_NEAR(mesh.points(0).z(), 0.0256, 1e-12);
  EXPECT_NEAR(mesh.points(1).x(), 0.2502, 1e-12);
  EXPECT_EQ(mesh.indices(2), 2U);

  msg::StationCompensation moved;
  moved.add_objects()->set_effect(2);
  moved.add_objects()->set_effect(5);
  moved.mutable_objects(1)->mutable_moved()->set_y(0.01);
  foxglove::FrameTransforms all;
  views::add_inside_transforms(all, two_layers(), moved, session_time(7));
  ASSERT_EQ(all.transforms_size(), 2);
  EXPECT_EQ(all.transforms(1).child_frame_id(), layer.frame_id());
  EXPECT_NE(all.transforms(0).child_frame_id(), layer.frame_id()) << "two layers of one name";
  const Eigen::Vector3d still = wire::vector_of(all.transforms(0).translation());
  EXPECT_LT((still - Eigen::Vector3d(0.0, 0.0, 0.8)).norm(), 1e-12);
  const Eigen::Vector3d follows = wire::vector_of(all.transforms(1).translation());
  EXPECT_LT((follows - Eigen::Vector3d(0.0, -0.01, 0.8)).norm(), 1e-12) << "y of H is -y of the camera here";
}

TEST(InsideView, ASceneWithoutLayersRemovesThoseOfTheLastScene) {
  const foxglove::SceneUpdate scene = views::inside_view(msg::InnerStructures());
  EXPECT_EQ(scene.entities_size(), 0);
  ASSERT_EQ(scene.deletions_size(), 1);
  EXPECT_EQ(scene.deletions(0).type(), foxglove::SceneEntityDeletion::ALL);
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

TEST(PhaseView, NamesThePhaseAsThePageDoes) {
  msg::StationState station;
  station.set_phase(msg::PHASE_PLANE_TO_BODY);
  EXPECT_EQ(views::phase_view(station).key(), "phase");
  EXPECT_EQ(views::phase_view(station).value(), "Approaching the skin");
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
    const codec::EncodedDepth encoded = encoder.encode(four_pixels(0.001));
    image.set_data(encoded.bytes);
    source.publish(wire::make_message(wire::kCameraDepth, session_time(1), image, encoded.key_frame));
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

/// A maker of views between two hubs, with a viewer that has subscribed to `topic`.
struct ViewStage {
  explicit ViewStage(const wire::Topic& topic) {
    views.subscribe(viewer, {std::string(topic.name)});
    maker.subscriptions_changed();
  }
  /// The next message to the viewer; nullopt: none came within `patience`.
  std::optional<wire::Message> next(std::chrono::milliseconds patience = 5s) {
    const auto until = std::chrono::steady_clock::now() + patience;
    for (;;) {
      if (std::optional<wire::Message> message = views.next(viewer)) return message;
      if (std::chrono::steady_clock::now() > until) return std::nullopt;
      io.run_one_for(5ms);
    }
  }
  void publish_camera(std::uint32_t width = 2) {
    foxglove::CameraCalibration model;
    model.set_width(width);
    model.set_height(2);
    for (const double k : {2.0, 0.0, 0.0, 0.0, 4.0, 1.0, 0.0, 0.0, 1.0}) model.add_k(k);
    source.publish(wire::make_message(wire::kCameraInfo, session_time(1), model));
  }
  void publish_depth(std::int64_t captured_ns) {
    msg::DepthImage image;
    image.set_captured_ns(static_cast<std::uint64_t>(captured_ns));
    const codec::EncodedDepth encoded = encoder.encode(four_pixels(0.001));
    image.set_data(encoded.bytes);
    source.publish(wire::make_message(wire::kCameraDepth, session_time(captured_ns), image, encoded.key_frame));
  }
  void publish_color(std::int64_t captured_ns, std::uint8_t gray) {
    foxglove::CompressedImage image;
    wire::set_stamp(*image.mutable_timestamp(), session_time(captured_ns));
    image.set_frame_id(wire::kDepthFrameId);
    image.set_data(codec::encode_color({.width = 2, .height = 2, .rgb = std::vector<std::uint8_t>(12, gray)}, 95));
    source.publish(wire::make_message(wire::kCameraColor, session_time(captured_ns), image));
  }

  boost::asio::io_context io;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> stay = boost::asio::make_work_guard(io);
  hub::Hub source;
  hub::Hub views;
  std::vector<std::string> said;
  views::ViewMaker maker{io, source, views, [this](const std::string& line) { said.push_back(line); }};
  codec::DepthEncoder encoder{codec::DepthStreamSettings{}};
  hub::SubscriberId viewer = views.join("viewer", "", [] {});
};

foxglove::PointCloud cloud_in(const std::optional<wire::Message>& message) {
  foxglove::PointCloud cloud;
  EXPECT_TRUE(message && cloud.ParseFromString(*message->payload));
  return cloud;
}

TEST(ViewMaker, ACloudHasTheColourOfItsOwnExposureThoughThatIsPublishedLater) {
  ViewStage stage(views::kCloudView);
  stage.publish_camera();
  constexpr std::int64_t kFrame_ns = 33'000'000;
  stage.publish_color(kFrame_ns, 50);
  for (int frame = 2; frame < 6; ++frame) {
    stage.publish_depth(frame * kFrame_ns);
    stage.publish_color(frame * kFrame_ns, static_cast<std::uint8_t>(40 * frame));
    const foxglove::PointCloud cloud = cloud_in(stage.next());
    ASSERT_EQ(color_of(cloud, 0).size(), 4u);
    EXPECT_NEAR(color_of(cloud, 0)[0], 40 * frame, 4);
  }
}

TEST(ViewMaker, ACloudWhoseColourDoesNotComeIsShownAfterATenthOfASecond) {
  ViewStage stage(views::kCloudView);
  stage.publish_camera();
  stage.publish_depth(10'000'000);
  EXPECT_TRUE(color_of(cloud_in(stage.next()), 0).empty()) << "a camera without colour";
  stage.publish_color(20'000'000, 200);
  stage.publish_depth(900'000'000);
  EXPECT_TRUE(color_of(cloud_in(stage.next()), 0).empty()) << "no colour of another moment";
}

TEST(ViewMaker, AViewerThatComesLaterGetsTheLayersThatWerePublishedOnce) {
  ViewStage stage(views::kInsideView);
  stage.source.publish(wire::make_message(wire::kStationInside, session_time(1), two_layers()));
  ASSERT_TRUE(stage.next());
  const hub::SubscriberId later = stage.views.join("later", "", [] {});
  stage.views.subscribe(later, {std::string(views::kInsideView.name)});
  stage.maker.subscriptions_changed();
  const std::optional<wire::Message> layers = stage.views.next(later);
  foxglove::SceneUpdate scene;
  ASSERT_TRUE(layers && scene.ParseFromString(*layers->payload));
  EXPECT_EQ(scene.entities_size(), 2);
}

TEST(ViewMaker, LayersThatAreNotValidAreNotShownAndSaidOnce) {
  ViewStage stage(views::kInsideView);
  msg::InnerStructures inside = two_layers();
  inside.mutable_structures(0)->set_triangles(std::string("\x09\x00\x01\x00\x02\x00", 6));
  for (int time = 1; time < 4; ++time)
    stage.source.publish(wire::make_message(wire::kStationInside, session_time(time), inside));
  EXPECT_FALSE(stage.next(100ms));
  ASSERT_EQ(stage.said.size(), 1u);
  EXPECT_NE(stage.said[0].find("/station/inside"), std::string::npos) << stage.said[0];
}

TEST(ViewMaker, SaysThatImagesDoNotFitTheCamerasModel) {
  ViewStage stage(views::kCloudView);
  stage.publish_camera(3);
  stage.publish_depth(10'000'000);
  EXPECT_FALSE(stage.next(500ms));
  ASSERT_EQ(stage.said.size(), 1u);
  EXPECT_NE(stage.said[0].find("the camera's model"), std::string::npos) << stage.said[0];
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
  wire::Message damaged{wire::kCameraDepth, session_time(2), std::make_shared<const std::string>("\xff\xff"), 0, true};
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
