#include "clients/mixed/compose/mixed_view.h"

#include "clients/mixed/compose/camouflage.h"
#include "clients/mixed/compose/ghost.h"
#include "clients/mixed/compose/hand_layer.h"
#include "clients/mixed/compose/misalignment.h"

namespace telepalp::mixed {
namespace {

constexpr std::array<int, 3> kToolColor{232, 150, 40};

void draw_tool(ColorImage& image, const View& view, const StandingDevice& device, const Vector<World>& gap) {
  const auto [from, to] = device.handle();
  const Cone& cone = device.model.handle;
  const Mask tool = cone_mask(view, from + gap, to + gap, cone.from_radius_m, cone.to_radius_m);
  for (std::size_t i = 0; i < tool.on.size(); ++i)
    for (std::size_t c = 0; tool.on[i] != 0 && c < 3; ++c)
      image.rgb[3 * i + c] = static_cast<std::uint8_t>(kToolColor[c]);
}

/// The pixels of the device, and of the space in which the hand grasps it.
Mask region_of(const Mask& device, const std::optional<GraspingArea>& grasp) {
  Mask region = device;
  if (grasp) fill_hull(region, grasp->corners(grasp->outer_px));
  return region;
}

}  // namespace

MixedImage mix(const ColorImage& live, const View& view, const Background& background, const StandingDevice& device,
               const MaskMargin& margin, const Vector<World>& tool_minus_device, const MixedSettings& settings) {
  const auto [from, to] = device.handle();
  const std::optional<GraspingArea> grasp = grasping_area(view, from, to);
  const Mask device_at = device_mask(device, view, margin);
  const Mask region = region_of(device_at, grasp);
  const int ring_px = settings.completion.ring_px;
  MixedImage out{.color = live, .emptied = device_at, .hand = {}, .searched = with_ring(region, ring_px)};
  const Synthesis synthesis = synthesise(background, view, out.searched, settings.completion);

  out.hand =
      settings.glove
          ? both(hand_by_colour(live, HandColourTable(*settings.glove), settings.difference.clean_up), out.searched)
          : hand_before_background(live, synthesis.color, synthesis.known, device_at, settings.difference);
  add(out.emptied, both(out.hand, region));
  out.unknown_px = out.emptied.count() - both(out.emptied, synthesis.known).count();
  Mask covered = out.emptied;
  add(covered, out.hand);
  out.ring_levels = ring_difference(live, synthesis, covered, ring_px);
  paint_background(out.color, synthesis, out.emptied, ring_px);
  out.ghost = kGhost * ghost_opacity(joint_room(device));
  if (out.ghost > 0.0) draw_ghost(out.color, live, device_at, out.ghost);
  draw_tool(out.color, view, device, tool_minus_device);
  if (!grasp) return out;
  const Point<World> device_point{0.65 * from.m + 0.35 * to.m};  // the grip, 35 % of the handle from the tip's end
  if (settings.shifted)
    out.shift_px =
        hand_shift_px(view, device_point, device_point + tool_minus_device).value_or(Eigen::Vector2d::Zero());
  draw_hand(out.color, live, out.hand, *grasp, out.shift_px);
  return out;
}

ColorImage faded(const ColorImage& live, const ColorImage& mixed, double opacity) {
  ColorImage out = live;
  for (std::size_t i = 0; i < out.rgb.size(); ++i) out.rgb[i] = blended(live.rgb[i], mixed.rgb[i], opacity);
  return out;
}

}  // namespace telepalp::mixed
