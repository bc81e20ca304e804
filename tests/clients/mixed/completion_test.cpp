#include <gtest/gtest.h>

#include "clients/mixed/background/blend_field.h"
#include "clients/mixed/background/completion.h"
#include "support/program/parallel.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector3d;

const Intrinsics kLens{256, 192, 238, 238, 127.5, 95.5};

const View& doctors_view() {
  static const View view{kLens, looking_at({{0.08, -0.62, 0.6}}, {{0.0, 0.12, 0.08}})};
  return view;
}

/// Small backgrounds, rendered once.
const Background& planes() {
  static const Background desk = desk_background(kLens, 60, ProxyKind::Planes, {}, false, program::processors());
  return desk;
}
const Background& depths() {
  static const Background desk = desk_background(kLens, 60, ProxyKind::Depth, {}, false, program::processors());
  return desk;
}

Mask device_region() {
  const StandingDevice device = standing_device();
  Mask mask = device_mask(device, doctors_view(), expected_margin());
  const RenderedDesk desk =
      render({.device = device, .hands = {holding_hand(device, Vector3d::Zero())}}, doctors_view());
  add(mask, desk.mask(Label::Hand));
  return mask;
}

TEST(Completion, ShowsTheTrueBackgroundAndTheDepthProxyShowsItBetter) {
  const Mask region = device_region();
  const ColorImage truth = render({}, doctors_view()).color;
  const Synthesis by_planes = synthesise(planes(), doctors_view(), region);
  const Synthesis by_depths = synthesise(depths(), doctors_view(), region);
  EXPECT_EQ(by_planes.known.count(), region.count());
  const double planes_db = psnr_db(by_planes.color, truth, region), depths_db = psnr_db(by_depths.color, truth, region);
  ColorImage painted = truth;
  paint_background(painted, by_depths, region, 0);
  const double similarity = ssim(painted, truth, region);
  std::printf("planes %.1f dB; depths %.1f dB, ssim %.3f\n", planes_db, depths_db, similarity);
  EXPECT_GE(similarity, 0.92);
  EXPECT_GE(planes_db, 28.0);
  EXPECT_GE(depths_db, 32.0);
  EXPECT_GT(depths_db, planes_db);
}

TEST(Completion, FromASourcesOwnViewItIsThatImage) {
  const SourceImage& source = planes().sources()[7];
  Mask all(kLens.width, kLens.height, 1);
  const Synthesis synthesis = synthesise(planes(), source.view, all);
  Mask inner(kLens.width, kLens.height);
  for (int y = 40; y < 150; ++y)
    for (int x = 40; x < 200; ++x) inner.on[inner.index(x, y)] = synthesis.known.on[inner.index(x, y)];
  EXPECT_GE(psnr_db(synthesis.color, source.color, inner), 38.0);
}

TEST(Completion, ComparesViewingDirectionsInTheWorldNotInTheCamerasFrame) {
  // Of two sources at the same place one may be turned. In the world's frame both see a vertex from the same direction,
  // so both serve it equally well. In the frames of the sources these directions differ.
  const std::size_t vertex = 24 * 5 + 12;
  const Vector3d eye = doctors_view().world_from_eye.iso.translation();
  const VertexCameras chosen = choose_cameras(planes(), vertex, eye, 1);
  ASSERT_EQ(chosen.count, 1);
  const Vector3d at = planes().proxy().vertices[vertex];
  const double best = (at - planes().sources()[chosen.source[0]].view.world_from_eye.iso.translation())
                          .normalized()
                          .dot((at - eye).normalized());
  for (std::size_t s = 0; s < planes().sources().size(); ++s) {
    if (planes().direction(vertex, s).norm() < 0.5F) continue;
    const Vector3d from = planes().sources()[s].view.world_from_eye.iso.translation();
    EXPECT_LE((at - from).normalized().dot((at - eye).normalized()), best + 1e-6);
  }
}

TEST(Completion, AnImageDoesNotServeAVertexBehindAnObject) {
  // A wall between camera and vertex hides the vertex: the source's depth map shows the wall.
  Proxy proxy = plane_proxy({-0.5, 1.0, -0.5}, {1, 0, 0}, {0, 0, 1}, 4, 4);
  const std::size_t far_vertices = proxy.vertices.size();
  append(proxy, plane_proxy({-0.2, 0.5, -0.2}, {0.4, 0, 0}, {0, 0, 0.4}, 4, 4));
  const View view{kLens, looking_at({{0, -0.5, 0}}, {{0, 1, 0}})};
  const Result<Background> background =
      Background::prepare({{view, {kLens.width, kLens.height, std::vector<std::uint8_t>(256 * 192 * 3, 90)}}}, proxy);
  ASSERT_TRUE(background) << to_string(background.error());
  EXPECT_EQ(background->direction(12, 0).norm(), 0.0F);  // middle of the far plane
  EXPECT_NEAR(background->direction(far_vertices + 12, 0).norm(), 1.0F, 1e-5F);
}

TEST(Completion, WithoutASourceThatSeesTheSceneAllStaysUnknownAndTheLiveImageIsKept) {
  const View away{kLens, looking_at({{0, -2.0, 0.6}}, {{0, -4, 0.6}})};
  Proxy proxy = plane_proxy({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4);
  proxy.triangles.push_back({0, 0, 1});  // without area
  const Result<Background> background =
      Background::prepare({{away, {kLens.width, kLens.height, std::vector<std::uint8_t>(256 * 192 * 3, 90)}}}, proxy);
  ASSERT_TRUE(background);
  const Mask region = device_region();
  const Synthesis synthesis = synthesise(*background, doctors_view(), region);
  EXPECT_EQ(synthesis.known.count(), 0U);
  ColorImage live = render({.device = standing_device()}, doctors_view()).color;
  const ColorImage before = live;
  paint_background(live, synthesis, region, 8);
  EXPECT_EQ(live.rgb, before.rgb);
  EXPECT_FALSE(ring_difference(before, synthesis, region, 8));
}

TEST(Completion, TheRingHidesTheBorderThatAHardEdgeShows) {
  const Mask region = device_region();
  const ColorImage truth = render({}, doctors_view()).color;
  const Synthesis synthesis = synthesise(planes(), doctors_view(), with_ring(region, 12));
  ColorImage soft = truth, hard = truth;
  paint_background(soft, synthesis, region, 12);
  paint_background(hard, synthesis, region, 0);
  const double soft_step = border_step(soft, truth, region), hard_step = border_step(hard, truth, region);
  std::printf("step across the border: ring %.2f, hard edge %.2f levels\n", soft_step, hard_step);
  EXPECT_LE(soft_step, 3.0);
  EXPECT_LT(soft_step, 0.75 * hard_step);
}

TEST(Completion, SaysThatTheBackgroundHasChangedOrTheLightIsOff) {
  const Mask region = device_region();
  const ColorImage live = render({.device = standing_device()}, doctors_view()).color;
  const Synthesis synthesis = synthesise(planes(), doctors_view(), with_ring(region, 12));
  EXPECT_LT(*ring_difference(live, synthesis, region, 12), kChangedRing_levels);
  const ColorImage dark = render({.light = 0.4, .device = standing_device()}, doctors_view()).color;
  EXPECT_GT(*ring_difference(dark, synthesis, region, 12), kChangedRing_levels);
}

TEST(Completion, WeightsOfSeveralCamerasSumToOneAndFavourTheNearest) {
  const Vector3d eye = doctors_view().world_from_eye.iso.translation();
  for (std::size_t vertex = 0; vertex < planes().proxy().vertices.size(); vertex += 7) {
    const VertexCameras chosen = choose_cameras(planes(), vertex, eye, 4);
    if (chosen.count == 0) continue;
    float sum = 0.0F;
    for (int i = 0; i < chosen.count; ++i) {
      sum += chosen.weight[static_cast<std::size_t>(i)];
      EXPECT_LE(chosen.weight[static_cast<std::size_t>(i)], chosen.weight[0] + 1e-6F);
    }
    EXPECT_NEAR(sum, 1.0F, 1e-5F);
    EXPECT_EQ(chosen.source[0], choose_cameras(planes(), vertex, eye, 1).source[0]);
  }
}

TEST(Background, RefusesWhatCannotBePainted) {
  const Proxy plane = plane_proxy({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 1);
  const ColorImage grey{kLens.width, kLens.height, std::vector<std::uint8_t>(256 * 192 * 3, 90)};
  EXPECT_NE(Background::prepare({}, plane).error().what.find("no image"), std::string::npos);
  Intrinsics other = kLens;
  other.width = 300;
  EXPECT_NE(Background::prepare({{{other, {}}, grey}}, plane).error().what.find("intrinsics"), std::string::npos);
  EXPECT_NE(Background::prepare({{doctors_view(), grey}}, {}).error().what.find("no triangle"), std::string::npos);
  Proxy broken = plane;
  broken.triangles.push_back({0, 1, 99});
  EXPECT_NE(Background::prepare({{doctors_view(), grey}}, broken).error().what.find("does not exist"),
            std::string::npos);
}

}  // namespace
}  // namespace telepalp::mixed
