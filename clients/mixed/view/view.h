#pragma once

#include <Eigen/Core>
#include <optional>

#include "proto/words/frames.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::mixed {

/// World (W)  fixed to the board of markers on the doctor's desk; z up, x and y on the desk.
/// Eye (E)    the doctor's camera: x right and y down in the image, z into the scene.
struct World {};
struct Eye {};

/// A camera at the time of one image.
struct View {
  Intrinsics intrinsics;
  Transform<World, Eye> world_from_eye;
};

/// Points nearer to the camera than this have no image [m].
inline constexpr double kNearest_m = 0.01;

/// The image of a point in the camera's frame [px]; nullopt for a point nearer than kNearest_m, or behind the camera.
[[nodiscard]] std::optional<Eigen::Vector2d> image_of(const Intrinsics& intrinsics, const Point<Eye>& point) noexcept;

/// The image of a point in the world's frame [px]; nullopt as for a point in the camera's frame.
[[nodiscard]] std::optional<Eigen::Vector2d> image_of(const View& view, const Point<World>& point) noexcept;

}  // namespace telepalp::mixed
