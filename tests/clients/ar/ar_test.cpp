#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include "clients/ar/augmented_view.h"
#include "clients/ar/canvas.h"
#include "clients/ar/depth_mesh.h"
#include "clients/ar/hand_avatar.h"
#include "clients/ar/isosurface.h"
#include "clients/ar/messages/from_messages.h"
#include "clients/ar/shapes.h"
#include "clients/ar/view_choice.h"
#include "support/images/image_file.h"

namespace telepalp::ar {
namespace {

/// A flat scene 1 m away, `width` x `height` pixels.
RgbdFrame flat_frame(int width, int height) {
  RgbdFrame frame;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  frame.depth = {width, height, 0.001, std::vector<std::uint16_t>(pixels, 1000)};
  frame.camera.depth = {width, height, 1.0 * width, 1.0 * width, width / 2.0, height / 2.0};
  frame.camera.color = frame.camera.depth;
  return frame;
}

std::array<int, 3> pixel(const ColorImage& image, int x, int y) {
  const auto at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

TEST(Isosurface, OfABallLiesOnTheBallWithNormalsOutwards) {
  const float radius = 0.7F, cell = 0.05F;
  const Mesh mesh = isosurface([&](const Eigen::Vector3f& at) { return at.norm() - radius; },
                               {Eigen::Vector3f::Constant(-1.0F), Eigen::Vector3f::Constant(1.0F)}, cell);
  ASSERT_GT(mesh.triangles.size(), 1000U);
  for (const Mesh::Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(vertex.at.norm(), radius, 0.1F * cell);
    EXPECT_GT(vertex.normal.dot(vertex.at.normalized()), 0.99F);
  }
}

TEST(Isosurface, OfABallIsClosed) {
  const Mesh mesh = isosurface([](const Eigen::Vector3f& at) { return at.norm() - 0.5F; },
                               {Eigen::Vector3f::Constant(-1.0F), Eigen::Vector3f::Constant(1.0F)}, 0.1F);
  EXPECT_EQ(mesh.vertices.size() + mesh.triangles.size() - mesh.triangles.size() * 3 / 2, 2U) << "Euler's number";
}

TEST(DepthMesh, HasTwoTrianglesForEverySquareOfAFlatScene) {
  const Mesh mesh = depth_mesh(flat_frame(40, 30));
  EXPECT_EQ(mesh.triangles.size(), 2U * 39U * 29U);
  for (const Mesh::Vertex& vertex : mesh.vertices)
    EXPECT_LT(vertex.normal.z(), -0.99F) << "normals point to the camera";
}

TEST(DepthMesh, NoTriangleSpansAJump) {
  RgbdFrame frame = flat_frame(40, 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 20; x < 40; ++x) frame.depth.samples[static_cast<std::size_t>(y * 40 + x)] = 1300;
  const Mesh mesh = depth_mesh(frame);
  EXPECT_EQ(mesh.triangles.size(), 2U * (19U + 19U) * 29U);
  for (const auto& triangle : mesh.triangles) {
    const float z = mesh.vertices[triangle[0]].at.z();
    for (const std::uint32_t corner : triangle) EXPECT_NEAR(mesh.vertices[corner].at.z(), z, 0.01F);
  }
}

TEST(DepthMesh, LonePixelsAndHolesGiveNoTriangle) {
  RgbdFrame frame = flat_frame(40, 30);
  std::fill(frame.depth.samples.begin(), frame.depth.samples.end(), std::uint16_t{0});
  frame.depth.samples[15 * 40 + 20] = 900;
  EXPECT_TRUE(depth_mesh(frame).triangles.empty());
}

TEST(DepthMesh, ColourOfAnotherSizeIsTakenFromTheSamePlace) {
  RgbdFrame frame = flat_frame(40, 30);
  frame.color = {80, 60, std::vector<std::uint8_t>(80 * 60 * 3, 0)};
  for (int y = 0; y < 60; ++y)
    for (int x = 40; x < 80; ++x) frame.color.rgb[static_cast<std::size_t>(3 * (y * 80 + x))] = 255;
  frame.camera.color = {80, 60, 80.0, 80.0, 40.0, 30.0};
  const Mesh mesh = depth_mesh(frame);
  EXPECT_LT(mesh.vertices[10].color.x(), 0.01F);
  EXPECT_GT(mesh.vertices[30].color.x(), 0.99F);
}

TEST(Canvas, TheNearerOfTwoHidesTheOtherInEitherOrder) {
  const ViewCamera camera = look_at({0, 0, -1}, {0, 0, 0}, {0, -1, 0}, 0.8F, 64, 64);
  const Lights lights{{0, 0, -1}, {0, 0, -1}};
  const ShadowMap shadow({0, 0, 0}, lights.key, 1.0F);
  const Mesh near = painted(ball({0, 0, -0.3F}, 0.1F), {1, 0, 0}), far = painted(ball({0, 0, 0.3F}, 0.1F), {0, 1, 0});
  for (const bool near_first : {true, false}) {
    Canvas canvas(64, 64, Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero());
    canvas.draw(near_first ? near : far, camera, lights, shadow, {});
    canvas.draw(near_first ? far : near, camera, lights, shadow, {});
    const auto [red, green, blue] = pixel(canvas.resolved(), 32, 32);
    EXPECT_GT(red, 150);
    EXPECT_EQ(green, 0);
  }
}

TEST(Canvas, ATriangleBehindTheEyeIsNotDrawn) {
  const ViewCamera camera = look_at({0, 0, -1}, {0, 0, 0}, {0, -1, 0}, 0.8F, 32, 32);
  const Lights lights{{0, 0, -1}, {0, 0, -1}};
  Canvas canvas(32, 32, Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero());
  canvas.draw(ball({0, 0, -1}, 0.5F), camera, lights, ShadowMap({0, 0, 0}, lights.key, 1.0F), {.two_sided = true});
  EXPECT_EQ(canvas.resolved().rgb.size(), 32U * 32U * 3U);
}

TEST(ShadowMap, IsDarkBehindACasterAndLightBesideIt) {
  ShadowMap shadow({0, 0, 0}, {0, 0, -1}, 0.5F);
  shadow.add(ball({0, 0, -0.1F}, 0.05F));
  EXPECT_EQ(shadow.light_at({0, 0, 0}), 0.0F);
  EXPECT_EQ(shadow.light_at({0.2F, 0, 0}), 1.0F);
  EXPECT_EQ(shadow.light_at({0, 0, -0.3F}), 1.0F) << "before the caster";
  EXPECT_EQ(shadow.light_at({10, 0, 0}), 1.0F) << "off the map";
}

TEST(HandAvatar, TouchesTheSkinWithItsPadsAndNothingElseGoesIn) {
  float lowest = 1.0F;
  for (const Mesh::Vertex& vertex : hand_avatar().skin.vertices) lowest = std::min(lowest, vertex.at.z());
  EXPECT_NEAR(lowest, 0.0F, 0.004F);
}

TEST(HandAvatar, TurnsRedderTheDeeperItIs) {
  double before = 0.0;
  for (const double depth_m : {0.0, 0.01, 0.03, 0.06}) {
    const Eigen::Vector3f color = avatar_color(depth_m);
    const double redness = color.x() / (color.y() + color.z());
    EXPECT_GT(redness, before);
    before = redness;
  }
  EXPECT_EQ(avatar_color(5.0), avatar_color(0.06));
}

AugmentedView small_view(const RgbdFrame& frame, std::optional<Touch> touch) {
  return {.frame = frame, .touch = std::move(touch), .figures = {{"force", "5 N"}}, .width_px = 320, .height_px = 240};
}

Touch touch_at(double z_m) {
  Touch touch;
  touch.hand = touch.proxy = {{0.0, 0.0, z_m}};
  touch.device = {{0.0, 0.0, z_m + 0.02}};
  touch.force = {{0.0, 0.0, -4.0}};
  touch.indentation_m = 0.02;
  return touch;
}

TEST(AugmentedView, IsTheSamePictureEveryTime) {
  const RgbdFrame frame = flat_frame(160, 120);
  EXPECT_EQ(draw(small_view(frame, touch_at(1.0))).rgb, draw(small_view(frame, touch_at(1.0))).rgb);
}

TEST(AugmentedView, ShowsTheTouchUnlessItIsNotFinite) {
  const RgbdFrame frame = flat_frame(160, 120);
  const ColorImage without = draw(small_view(frame, std::nullopt));
  EXPECT_NE(draw(small_view(frame, touch_at(1.0))).rgb, without.rgb);
  Touch broken = touch_at(1.0);
  broken.force.N.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(draw(small_view(frame, broken)).rgb, without.rgb);
}

TEST(AugmentedView, OfASceneWithoutASingleMeasurementIsStillAPicture) {
  RgbdFrame frame = flat_frame(160, 120);
  std::fill(frame.depth.samples.begin(), frame.depth.samples.end(), std::uint16_t{0});
  EXPECT_TRUE(is_well_formed(draw(small_view(frame, touch_at(0.8)))));
  EXPECT_TRUE(is_well_formed(draw(small_view(frame, std::nullopt))));
}

/// A square of vertices around `middle`, each `step_m` from the next, that faces the depth camera.
void add_board(Mesh& mesh, const Eigen::Vector3f& middle, float half_m, float step_m) {
  for (float x = -half_m; x <= half_m; x += step_m)
    for (float y = -half_m; y <= half_m; y += step_m)
      mesh.vertices.push_back({middle + Eigen::Vector3f(x, y, 0.0F), {0.0F, 0.0F, -1.0F}, {0.5F, 0.5F, 0.5F}});
}

TEST(ViewChoice, LooksPastAnObstacleThatHidesTheHandFromTheUsualSide) {
  const Eigen::Vector3f target(0.0F, 0.0F, 1.0F);
  Mesh body;
  add_board(body, target, 0.8F, 0.006F);
  const ViewCamera usual = chosen_view(body, target, 0.85F, 320, 240);
  EXPECT_TRUE(quality_of(usual, body, target).is_good());
  EXPECT_GT((usual.eye - target).y(), 0.4F) << "a three-quarter view";

  add_board(body, target + 0.4F * (usual.eye - target), 0.12F, 0.004F);
  EXPECT_LT(quality_of(usual, body, target).seen, 0.3F) << "the board hides the hand";
  const ViewCamera chosen = chosen_view(body, target, 0.85F, 320, 240);
  EXPECT_TRUE(quality_of(chosen, body, target).is_good());
}

TEST(ViewChoice, DoesNotLookAlongASheetWithAnEdge) {
  const Eigen::Vector3f target(0.0F, 0.0F, 1.0F);
  Mesh sheet;  // a narrow one, whose normal points down in the image: from below it is seen, from above edge on
  for (float x = -0.1F; x <= 0.1F; x += 0.004F)
    for (float along = -0.5F; along <= 0.5F; along += 0.004F)
      sheet.vertices.push_back({target + Eigen::Vector3f(x, -0.6F * along, 0.8F * along),
                                Eigen::Vector3f(0.0F, -0.8F, -0.6F),
                                {0.5F, 0.5F, 0.5F}});
  const ViewCamera chosen = chosen_view(sheet, target, 0.85F, 320, 240);
  EXPECT_GT(quality_of(chosen, sheet, target).facing, 0.5F);
}

TEST(AugmentedView, AForceOfZeroHasNoArrowAndNoTrouble) {
  const RgbdFrame frame = flat_frame(160, 120);
  Touch touch = touch_at(1.0);
  touch.force.N.setZero();
  touch.device = touch.proxy;
  EXPECT_TRUE(is_well_formed(draw(small_view(frame, touch))));
}

TEST(Png, HoldsThePixelsThatItWasGiven) {
  ColorImage image{5, 3, {}};
  for (int i = 0; i < 5 * 3 * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 5));
  const std::string file = images::encode_png(image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&header, file.data(), file.size()), 0);
  header.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(header));
  ASSERT_NE(png_image_finish_read(&header, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, image.rgb);
}

TEST(TouchOf, TheDrivesForceIsNamedAndDrawnAsNoContact) {
  msg::StationState state;
  state.mutable_device_camera()->set_z(0.6);
  state.mutable_force_n()->set_y(2.5);
  state.mutable_force_camera_n()->set_z(-2.5);
  const auto force_of = [&](msg::Phase phase) {
    state.set_phase(phase);
    return panel_of(state)[1];
  };
  for (const msg::Phase driven : {msg::PHASE_OUT_BODY, msg::PHASE_BODY_TO_PLANE, msg::PHASE_PLANE_TO_BODY}) {
    EXPECT_EQ(force_of(driven).name, "drive, not contact");
    EXPECT_TRUE(touch_of(state).force.N.isZero()) << "no arrow";
  }
  EXPECT_EQ(force_of(msg::PHASE_IN_BODY).name, "force of contact");
  EXPECT_EQ(force_of(msg::PHASE_IN_BODY).value, "2.50 N");
  EXPECT_EQ(touch_of(state).force.N.z(), -2.5);
}

}  // namespace
}  // namespace telepalp::ar
