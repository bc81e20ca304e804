#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/view/mask.h"
#include "clients/mixed/view/view.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::mixed {

/// A right hand around a handle, with its forearm.
struct HoldingHand {
  Point<World> grip;     ///< middle of the grasp
  Vector<World> handle;  ///< unit, from the tip to the other end
  Vector<World> arm;     ///< unit, from the grip to the elbow
  std::array<std::uint8_t, 3> color{205, 150, 120};
};

/// A desk with six things on it, before two walls. The world's origin is in the middle of the desk, y points to the
/// back wall. All surfaces are matt, so that their colour does not depend on the viewpoint.
struct DeskScene {
  bool printed_pages = false;  ///< pages of fine print on desk and wall, instead of soft textures alone
  double light = 1.0;
  std::optional<StandingDevice> device = {};
  std::vector<HoldingHand> hands = {};
};

enum class Label : std::uint8_t { Background, Device, Hand };

/// What a camera sees, by casting a ray through each pixel's centre, and what it truly is.
struct RenderedDesk {
  ColorImage color;
  DepthImage depth;           ///< in units of 0.1 mm
  std::vector<Label> labels;  ///< one for each pixel

  [[nodiscard]] Mask mask(Label label) const;
};

/// `threads`: number of threads, for program::for_each_parallel().
[[nodiscard]] RenderedDesk render(const DeskScene& scene, const View& view, int threads = 1);

/// A camera at `eye` that looks at `target`, with its x axis parallel to the desk.
[[nodiscard]] Transform<World, Eye> looking_at(const Point<World>& eye, const Point<World>& target);

/// Views of the doctor's head: positions within `radius_m` of a place before the desk, aimed within a cone of
/// `cone_rad` around the middle of the desk. The same `seed` gives the same views.
[[nodiscard]] std::vector<View> head_views(const Intrinsics& lens, int count, double radius_m, double cone_rad,
                                           std::uint64_t seed);

}  // namespace telepalp::mixed
