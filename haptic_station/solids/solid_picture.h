#pragma once

#include <span>

#include "haptic_station/solids/solid_tree.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::solids {

/// A solid in a picture, with its colour.
struct PaintedSolid {
  const SolidTree* tree;  ///< borrowed
  std::array<std::uint8_t, 3> rgb;
};

/// A view along parallel rays.
struct PictureView {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     ///< point in the picture's middle [m], in the solids' frame
  Eigen::Vector3d towards = -Eigen::Vector3d::UnitY();  ///< unit, from the eye into the scene
  Eigen::Vector3d up = -Eigen::Vector3d::UnitZ();       ///< unit, upwards in the picture
  double width_m = 0.4;
  int side_px = 512;
};

/// A square picture of solids by sphere tracing (Hart 1996): each ray advances by the distance to the nearest solid,
/// and neighbouring rays advance together while the nearest solid is farther away than they are from each other.
/// The light comes from the eye. White where a ray meets no solid within two picture widths in front of and behind
/// `center`.
[[nodiscard]] ColorImage picture_of(std::span<const PaintedSolid> solids, const PictureView& view);

}  // namespace telepalp::solids
