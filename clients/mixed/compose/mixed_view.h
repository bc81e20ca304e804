#pragma once

#include <optional>

#include "clients/mixed/background/completion.h"
#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/hand/grasping_area.h"
#include "clients/mixed/hand/hand_mask.h"

namespace telepalp::mixed {

struct MixedSettings {
  CompletionSettings completion = {};
  DifferenceSettings difference = {};
  std::optional<HandColour> glove = {};  ///< colour by which the hand is found; none: by its difference
  bool shifted = true;                   ///< false: the naive composition, which leaves the hand where it is
};

/// The doctor's view without the machine, with the masks and figures of how it was made.
struct MixedImage {
  ColorImage color;
  Mask emptied;  ///< pixels of device and hand, over which the background was painted
  Mask hand;
  /// Where the background is synthesised and the hand searched: device, grasping area, and the ring around both.
  Mask searched;
  std::size_t unknown_px = 0;                          ///< emptied pixels that the background does not show
  std::optional<double> ring_levels = {};              ///< ring_difference()
  Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();  ///< by how much the hand was moved
  double ghost = 0.0;                                  ///< opacity with which the device's ghost was drawn, 0 to kGhost
};
inline constexpr double kGhost = 0.6;  ///< opacity of the ghost where ghost_opacity() is 1

/// Removes device and hand from the live image, paints the background, draws the virtual tool where the coupling has
/// it, and the hand at the tool. Paper S3 (docs/sources.md) 3.1. `tool_minus_device`: the coupling's gap at the
/// image's instant. `live` has the size of the view's intrinsics.
[[nodiscard]] MixedImage mix(const ColorImage& live, const View& view, const Background& background,
                             const StandingDevice& device, const MaskMargin& margin,
                             const Vector<World>& tool_minus_device, const MixedSettings& settings = {});

/// `mixed` over `live` with an opacity from 0 to 1, both of one size.
[[nodiscard]] ColorImage faded(const ColorImage& live, const ColorImage& mixed, double opacity);

}  // namespace telepalp::mixed
