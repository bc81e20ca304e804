#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "clients/ar/overlay.h"
#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// What the station touched at the moment of the picture.
struct Touch {
  Point<DepthCamera> hand;  ///< where the avatar's pads are drawn: displaced to the proxy in contact (S1 §II.E)
  Point<DepthCamera> proxy;
  Point<DepthCamera> device;  ///< centre of the ball
  Force<DepthCamera> force;   ///< on the doctor's hand
  double indentation_m = 0.0;
  bool in_body = false;
};

struct AugmentedView {
  const RgbdFrame& frame;
  std::optional<Touch> touch;      ///< none: only the patient is drawn
  std::vector<PanelLine> figures;  ///< state, force, age: as words
  int width_px = 1280;
  int height_px = 960;
};

/// The picture. The frame must be well formed; a touch that is not finite is not drawn.
[[nodiscard]] ColorImage draw(const AugmentedView& view);

}  // namespace telepalp::ar
