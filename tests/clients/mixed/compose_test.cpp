#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "clients/mixed/compose/camouflage.h"
#include "clients/mixed/compose/ghost.h"
#include "clients/mixed/compose/hand_layer.h"
#include "clients/mixed/compose/misalignment.h"
#include "clients/mixed/compose/mixed_view.h"
#include "clients/mixed/hand/hand_mask.h"
#include "support/program/parallel.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::mixed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::chrono::milliseconds;

const View kView{kDeskLens, looking_at({{0.08, -0.62, 0.6}}, {{0.0, 0.12, 0.08}})};

TEST(HandShift, IsTheDifferenceOfTwoImagesNotTheImageOfAVector) {
  const Point<World> device{{0.02, 0.1, 0.12}}, tool{{0.02, 0.1, 0.145}};
  const auto shift = hand_shift_px(kView, device, tool);
  ASSERT_TRUE(shift);
  EXPECT_LT((*image_of(kView, device) + *shift - *image_of(kView, tool)).norm(), 1e-9);
  const auto elsewhere = hand_shift_px(kView, {{0.02, -0.2, 0.3}}, {{0.02, -0.2, 0.325}});
  ASSERT_TRUE(elsewhere);
  EXPECT_GT((*shift - *elsewhere).norm(), 3.0);  // the same vector, nearer to the eye
  EXPECT_FALSE(hand_shift_px(kView, device, {{0.0, -3.0, 1.0}}));
}

TEST(CouplingEnds, AreThoseOfTheImagesInstant) {
  const std::vector<CouplingEnds> states{{session_time(0), {{0, 0, 0}}, {{0, 0, 0}}},
                                         {session_time(10'000'000), {{0.01, 0, 0}}, {{0, 0.02, 0}}}};
  const auto middle = ends_at(states, session_time(2'500'000), milliseconds(20));
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->device.m.x(), 0.0025, 1e-12);
  EXPECT_NEAR(middle->tool.m.y(), 0.005, 1e-12);
  EXPECT_EQ(ends_at(states, session_time(25'000'000), milliseconds(20))->device.m.x(), 0.01);
  EXPECT_FALSE(ends_at(states, session_time(31'000'000), milliseconds(20)));
  EXPECT_FALSE(ends_at(states, session_time(-1), milliseconds(20)));
  EXPECT_FALSE(ends_at({}, session_time(0), milliseconds(20)));
  EXPECT_FALSE(ends_at(states, session_time(5'000'000), milliseconds(2))) << "in a gap of the station's states";
  EXPECT_TRUE(ends_at(states, session_time(9'000'000), milliseconds(2)));
}

/// The hand's pixels within the inner grasping area.
Vector2d middle_near(const Mask& hand, const GraspingArea& grasp) {
  Vector2d sum = Vector2d::Zero();
  double weight = 0.0;
  for (int y = 0; y < hand.height; ++y)
    for (int x = 0; x < hand.width; ++x)
      if (hand.at(x, y)) {
        const double here = grasp.weight_at({x, y});
        sum += here * Vector2d(x, y);
        weight += here;
      }
  return sum / weight;
}

TEST(HandLayer, DrawsTheHandWhereAHandAtTheToolWouldBe) {
  const StandingDevice device = standing_device();
  const Vector3d misalignment(0.0, 0.0, 0.025);
  const HoldingHand held = holding_hand(device, Vector3d::Zero());
  const RenderedDesk live = render({.device = device, .hands = {held}}, kView);
  const StandingDevice moved = moved_device(device, misalignment);
  const RenderedDesk truth = render({.device = moved, .hands = {holding_hand(moved, Vector3d::Zero())}}, kView);
  const Point<World> tool{Vector3d(held.grip.m + misalignment)};
  const auto shift = hand_shift_px(kView, held.grip, tool);
  ASSERT_TRUE(shift);
  const GraspingArea grasp{*image_of(kView, held.grip) - Vector2d(14, 0), *image_of(kView, held.grip) + Vector2d(14, 0),
                           70, 60};
  ColorImage drawn{kDeskLens.width, kDeskLens.height, std::vector<std::uint8_t>(live.color.rgb.size(), 0)};
  draw_hand(drawn, live.color, live.mask(Label::Hand), grasp, *shift);
  Mask hand(kDeskLens.width, kDeskLens.height);
  for (std::size_t i = 0; i < hand.on.size(); ++i) hand.on[i] = drawn.rgb[3 * i] > 60 ? 1 : 0;
  const GraspingArea at_tool{grasp.a + *shift, grasp.b + *shift, grasp.outer_px, grasp.inner_px};
  const Vector2d there = middle_near(truth.mask(Label::Hand), at_tool);
  const double error_px = (middle_near(hand, at_tool) - there).norm();
  const double naive_px = (middle_near(live.mask(Label::Hand), grasp) - there).norm();
  std::printf("hand at the grip: %.2f px off, naive %.1f px\n", error_px, naive_px);
  EXPECT_LE(error_px, 1.0);
  EXPECT_GE(naive_px, 8.0);
}

TEST(HandLayer, LeavesTheArmWhereItIs) {
  const StandingDevice device = standing_device();
  const HoldingHand held = holding_hand(device, Vector3d::Zero());
  const RenderedDesk live = render({.device = device, .hands = {held}}, kView);
  const Mask hand = live.mask(Label::Hand);
  const GraspingArea grasp{*image_of(kView, held.grip), *image_of(kView, held.grip) + Vector2d(1, 0), 60, 12};
  ColorImage drawn{kDeskLens.width, kDeskLens.height, std::vector<std::uint8_t>(live.color.rgb.size(), 0)};
  draw_hand(drawn, live.color, hand, grasp, {0, -12});
  for (int y = 0; y < hand.height; ++y)
    for (int x = 0; x < hand.width; ++x) {
      const std::size_t pixel = 3 * hand.index(x, y);
      const bool still = grasp.weight_at({x, y}) == 0.0 && grasp.weight_at({x, y + 12.0}) == 0.0;
      if (hand.at(x, y) && still) {
        ASSERT_EQ(drawn.rgb[pixel], live.color.rgb[pixel]) << x << "," << y;
      }
    }
}

TEST(HandLayer, AShiftLargerThanTheImageOrAHandAtTheBorderDrawsNothingOutside) {
  Mask hand(8, 6, 1);
  const ColorImage live{8, 6, std::vector<std::uint8_t>(8 * 6 * 3, 200)};
  for (const Vector2d& shift : {Vector2d(100, 100), Vector2d(-1e9, 3), Vector2d(2.5, -1.5)}) {
    ColorImage drawn{8, 6, std::vector<std::uint8_t>(8 * 6 * 3, 0)};
    draw_hand(drawn, live, hand, {{4, 3}, {5, 3}, 4, 2}, shift);
    EXPECT_EQ(drawn.rgb.size(), 8U * 6U * 3U);
  }
  ColorImage untouched = live;
  draw_hand(untouched, live, Mask(8, 6), {{4, 3}, {5, 3}, 4, 2}, {3, 3});
  EXPECT_EQ(untouched.rgb, live.rgb);
}

const Background& depth_desk() {
  static const Background desk = desk_background(kDeskLens, 40, ProxyKind::Depth, {}, false, program::processors());
  return desk;
}

/// Intersection over union of the hand's mask and the true one, within the searched pixels.
struct HandFound {
  double before_background = 0.0;
  double by_colour = 0.0;
};

HandFound hand_found(const std::array<std::uint8_t, 3>& color, int hands) {
  const StandingDevice device = standing_device();
  DeskScene scene{.device = device, .hands = {holding_hand(device, Vector3d::Zero(), color)}};
  if (hands == 2) scene.hands.push_back({{{-0.06, 0.12, 0.09}}, {{1, 0, 0}}, {{-0.5, -0.8, 0.0}}, color});
  const RenderedDesk live = render(scene, kView);
  const Mask truth = live.mask(Label::Hand);
  HandColour known_color = fit_hand_colour(colors_of(live.color, truth));
  MixedSettings settings;
  const MaskMargin margin = calibrated_margin(0.3e-3, 0.001, {});
  const MixedImage behind = mix(live.color, kView, depth_desk(), device, margin, {}, settings);
  settings.glove = known_color;
  const MixedImage by_colour = mix(live.color, kView, depth_desk(), device, margin, {}, settings);
  const Mask expected = both(truth, behind.searched);
  return {overlap_of(both(behind.hand, behind.searched), expected).iou,
          overlap_of(both(by_colour.hand, behind.searched), expected).iou};
}

TEST(HandMask, BeforeTheCompletedBackgroundABareHandNeedsNoGlove) {
  const HandFound found = hand_found({205, 150, 120}, 1);
  std::printf("bare hand: before the background %.3f, by colour alone %.3f\n", found.before_background,
              found.by_colour);
  EXPECT_GE(found.before_background, 0.9);
  EXPECT_LT(found.by_colour, found.before_background);  // the desk's wood has the hue of skin
}

TEST(HandMask, TwoHandsAreBothHands) { EXPECT_GE(hand_found({205, 150, 120}, 2).before_background, 0.88); }

TEST(HandMask, AGloveIsFoundByItsColour) { EXPECT_GE(hand_found({30, 150, 60}, 1).by_colour, 0.95); }

// Where glove and device have one colour, nothing tells them apart: a part of the glove before the device is lost.
TEST(HandMask, AGreyGloveBeforeAGreyDeviceIsFoundForTheLargerPart) {
  EXPECT_GE(hand_found({150, 150, 150}, 1).before_background, 0.65);
}

TEST(MixedView, HidesTheDeviceShowsTheToolAndLeavesTheRestOfTheImage) {
  const StandingDevice device = standing_device();
  const RenderedDesk live = render({.device = device, .hands = {holding_hand(device, Vector3d::Zero())}}, kView);
  const ColorImage empty = render({.hands = {holding_hand(device, {0, 0, 0.025})}}, kView).color;
  const MixedImage mixed = mix(live.color, kView, depth_desk(), device, expected_margin(), {{0, 0, 0.025}});
  EXPECT_EQ(mixed.unknown_px, 0U);
  Mask hidden = live.mask(Label::Device), outside(kDeskLens.width, kDeskLens.height, 1);
  const Mask around = with_ring(mixed.searched, 30), near_hand = with_ring(mixed.hand, 14);
  for (std::size_t i = 0; i < hidden.on.size(); ++i) {
    const bool tool = mixed.color.rgb[3 * i] == 232 && mixed.color.rgb[3 * i + 2] == 40;
    if (tool || near_hand.on[i] != 0) hidden.on[i] = 0;
    if (around.on[i] != 0) outside.on[i] = 0;
  }
  EXPECT_GE(psnr_db(mixed.color, empty, hidden), 27.0);
  EXPECT_LE(psnr_db(live.color, empty, hidden), 15.0);  // the device was there
  EXPECT_GE(psnr_db(mixed.color, live.color, outside), 90.0);
}

TEST(Camouflage, TheTableOfPhasesAndEventsIsThisOne) {
  std::ostringstream table;
  for (const Camouflage from : {Camouflage::Visible, Camouflage::Hiding, Camouflage::Hidden, Camouflage::Revealing}) {
    for (const PictureEvent on : {PictureEvent::Trusted, PictureEvent::Doubted, PictureEvent::FadeEnded})
      table << static_cast<int>(next(from, on));
    table << " ";
  }
  EXPECT_EQ(table.str(), "100 132 232 130 ");
}

CamouflageState after(CamouflageState state, const PictureTrust& trust, double seconds) {
  for (double t = 0.0; t < seconds; t += 1.0 / 60.0) state = advance(state, trust, 1.0 / 60.0);
  return state;
}

TEST(Camouflage, HidesTheDeviceOnlyAfterAllHasBeenWellForAWhile) {
  EXPECT_EQ(after({}, {}, 0.4).opacity, 0.0);
  const CamouflageState hidden = after({}, {}, 1.2);
  EXPECT_EQ(hidden.phase, Camouflage::Hidden);
  EXPECT_EQ(hidden.opacity, 1.0);
}

TEST(Camouflage, FadesOutWithinATenthOfASecondOnFaultLostMarkersOrAnOldImage) {
  const CamouflageState hidden = after({}, {}, 1.2);
  for (const PictureTrust& bad :
       {PictureTrust{.fault = true}, PictureTrust{.markers_seen = false}, PictureTrust{.image_age_s = 0.26},
        PictureTrust{.image_age_s = std::numeric_limits<double>::quiet_NaN()}})
    EXPECT_EQ(after(hidden, bad, 0.12).opacity, 0.0);
  EXPECT_EQ(after(hidden, {.image_age_s = 0.24}, 5.0).phase, Camouflage::Hidden);
}

TEST(Camouflage, AnAgeBetweenFreshAndOldNeitherHidesNorReveals) {
  CamouflageState state = after(after({}, {}, 1.2), {.image_age_s = 0.3}, 0.2);
  ASSERT_EQ(state.phase, Camouflage::Visible);
  state = after(state, {.image_age_s = 0.2}, 5.0);
  EXPECT_EQ(state.opacity, 0.0);
  EXPECT_EQ(after(state, {.image_age_s = 0.05}, 1.2).phase, Camouflage::Hidden);
}

TEST(Ghost, AJointAtAnEndHasNoRoom) {
  StandingDevice device = standing_device();
  EXPECT_GT(joint_room(device), 0.1);
  device.joints_rad[1] = device.model.joints[1].most_rad + 0.05;
  EXPECT_EQ(joint_room(device), 0.0);
}

TEST(Ghost, IsDrawnInTheComposedImageAtAnEndOfTheWorkspaceAndOtherwiseNot) {
  const View view = head_views(kDeskLens, 1, 0.2, 0.2, 41).front();
  StandingDevice device = standing_device();
  const auto composed = [&] {
    return mix(render({.device = device}, view, program::processors()).color, view, depth_desk(), device,
               expected_margin(), {});
  };
  EXPECT_EQ(composed().ghost, 0.0);
  device.joints_rad[0] = device.model.joints[0].most_rad;
  EXPECT_DOUBLE_EQ(composed().ghost, kGhost);
}

TEST(Camouflage, TheGhostAppearsAtTheEndsOfTheWorkspace) {
  EXPECT_EQ(ghost_opacity(0.4), 0.0);
  EXPECT_EQ(ghost_opacity(0.01), 1.0);
  EXPECT_GT(ghost_opacity(0.05), ghost_opacity(0.08));
}

}  // namespace
}  // namespace telepalp::mixed
