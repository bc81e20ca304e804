#include <algorithm>
#include <vector>

#include "clients/mixed/compose/hand_layer.h"
#include "clients/mixed/compose/misalignment.h"
#include "clients/mixed/compose/mixed_view.h"
#include "proto/words/numbers/quantile.h"
#include "support/program/parallel.h"
#include "tests/bench/effects/thread_time.h"
#include "tests/bench/mixed/section.h"
#include "tests/clients/mixed/desk_truth.h"

namespace telepalp::bench {
namespace {

using namespace mixed;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Mean place of the hand's pixels within `radius_px` of `around`.
Vector2d middle_near(const Mask& hand, const Vector2d& around, double radius_px) {
  Vector2d sum = Vector2d::Zero();
  double count = 0.0;
  for (int y = 0; y < hand.height; ++y)
    for (int x = 0; x < hand.width; ++x)
      if (hand.at(x, y) && (Vector2d(x, y) - around).norm() <= radius_px) {
        sum += Vector2d(x, y);
        count += 1.0;
      }
  return count > 0.0 ? Vector2d(sum / count) : Vector2d(Vector2d::Constant(1e3));
}

/// Distances from a rendered hand that holds the tool [px]: of the drawn hand's grip, of the whole drawn hand, and of a
/// hand that is not moved.
struct HandErrors {
  double grip_px, rest_px, naive_px;
};

HandErrors hand_errors(const View& view, const Vector3d& gap_m) {
  const StandingDevice device = standing_device();
  const HoldingHand held = holding_hand(device, Vector3d::Zero());
  const RenderedDesk live = render({.device = device, .hands = {held}}, view, program::processors());
  // The truth is a hand that holds the tool: fingers and handle hide each other as they do in the live image.
  const StandingDevice tool = moved_device(device, gap_m);
  const Mask at_tool =
      render({.device = tool, .hands = {holding_hand(tool, Vector3d::Zero())}}, view, program::processors())
          .mask(Label::Hand);
  const Vector2d shift = *hand_shift_px(view, held.grip, {Vector3d(held.grip.m + gap_m)});
  const auto [from, to] = device.handle();
  const GraspingArea grasp = *grasping_area(view, from, to);
  ColorImage drawn{kLens.width, kLens.height, std::vector<std::uint8_t>(live.color.rgb.size(), 0)};
  draw_hand(drawn, live.color, live.mask(Label::Hand), grasp, shift);
  Mask hand(kLens.width, kLens.height);
  for (std::size_t i = 0; i < hand.on.size(); ++i) hand.on[i] = drawn.rgb[3 * i] > 60 ? 1 : 0;
  // Both hands are measured in the same window around the true grip: half of the inner grasping area's width for the
  // grip, 90 px for the whole hand.
  const Vector2d grip = *image_of(view, Point<World>{Vector3d(held.grip.m + gap_m)});
  const double near_px = 0.5 * grasp.inner_px, wide_px = 90.0;
  return {(middle_near(hand, grip, near_px) - middle_near(at_tool, grip, near_px)).norm(),
          (middle_near(hand, grip, wide_px) - middle_near(at_tool, grip, wide_px)).norm(), shift.norm()};
}

void add_error_rows(std::vector<Row>& rows) {
  double grip = 0.0, rest = 0.0, naive = 1e9;
  for (const View& view : head_views(kLens, 4, 0.2, 0.2, 31)) {
    const HandErrors errors = hand_errors(view, {0.0, 0.0, 0.025});
    grip = std::max(grip, errors.grip_px);
    rest = std::max(rest, errors.rest_px);
    naive = std::min(naive, errors.naive_px);
  }
  rows.push_back(at_most("hand at the tool, at the grip, worst of 4 views", grip, "px", 1.0));
  rows.push_back(at_least("hand at the tool, naive composition, least of 4 views", naive, "px", 10.0));
  rows.push_back(measured("hand at the tool, whole hand, worst of 4 views", rest, "px"));
}

void add_time_rows(std::vector<Row>& rows) {
  const View view{kLens, looking_at({{0.05, -0.42, 0.45}}, {{0.0, 0.1, 0.1}})};
  const StandingDevice device = standing_device();
  const RenderedDesk live =
      render({.device = device, .hands = {holding_hand(device, Vector3d::Zero())}}, view, program::processors());
  for (const ProxyKind kind : {ProxyKind::Planes, ProxyKind::Depth}) {
    const Background desk = desk_background(kLens, 60, kind, {}, false, program::processors());
    std::vector<double> times_ms;
    double emptied = 0.0;
    for (int i = 0; i < 15; ++i) {
      const double before_us = thread_us();
      const MixedImage image = mix(live.color, view, desk, device, expected_margin(), {{0.0, 0.0, 0.025}});
      times_ms.push_back((thread_us() - before_us) * 1e-3);
      emptied = static_cast<double>(image.emptied.count()) / static_cast<double>(image.emptied.on.size());
    }
    const std::string name = kind == ProxyKind::Planes ? "planes" : "depth";
    rows.push_back(at_most("1024 x 768 on the processor, " + name + ": p50", quantile_of(times_ms, 0.5), "ms", 25.0));
    rows.push_back(measured("1024 x 768 on the processor, " + name + ": p95", quantile_of(times_ms, 0.95), "ms"));
    rows.push_back(measured("emptied region", 100.0 * emptied, "%"));
  }
}

}  // namespace

std::vector<Row> run_hand_section() {
  std::vector<Row> rows;
  add_error_rows(rows);
  add_time_rows(rows);
  return rows;
}

}  // namespace telepalp::bench
