#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "clients/ar/overlay.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// Hand and haptic device at the time of the picture, as the station published them.
struct Touch {
  Point<DepthCamera> hand;  ///< the avatar's fingertips; in contact, at the proxy (paper S1 §II.E, docs/sources.md)
  Point<DepthCamera> proxy;
  Point<DepthCamera> device;  ///< device point; centre of the drawn ball
  Force<DepthCamera> force;   ///< of the contact, on the doctor's hand; zero while the device is driven
  double indentation_m = 0.0;
  bool in_body = false;
  /// Rotation from the hand frame (hand_avatar.h) to the depth camera's; nullopt: the hand is drawn flat on the skin.
  std::optional<Eigen::Quaterniond> attitude = {};
};

struct AugmentedView {
  const RgbdFrame& frame;
  std::optional<Touch> touch;      ///< nullopt: only the patient is drawn
  std::vector<PanelLine> figures;  ///< text of the panel: state, force, age of the surface
  int width_px = 1280;
  int height_px = 960;
};

/// Renders the picture. `frame` must be well formed, width and height 1 to 4096. A non-finite touch is not drawn.
[[nodiscard]] ColorImage draw(const AugmentedView& view);

}  // namespace telepalp::ar
