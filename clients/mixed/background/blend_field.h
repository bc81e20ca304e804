#pragma once

#include <array>
#include <cstdint>

#include "clients/mixed/background/background.h"

namespace telepalp::mixed {

inline constexpr int kMostCameras = 4;  ///< source images that one vertex blends at most

/// The source images of one vertex and their weights, which sum to 1; `count` 0: no image shows the vertex.
struct VertexCameras {
  int count = 0;
  std::array<std::uint16_t, kMostCameras> source{};
  std::array<float, kMostCameras> weight{};
};

/// The `cameras` (1 to kMostCameras) source images that see the vertex from directions nearest to that from `eye_m`, a
/// point in the world's frame. A single image has weight 1. The weights of several are 1 - angle / limit, divided by
/// their sum. `angle` lies between the image's direction and that from `eye_m`; `limit` is the angle of the best image
/// that was not chosen. So an image fades out before another one takes its place. Source: Buehler et al., unstructured
/// lumigraph.
[[nodiscard]] VertexCameras choose_cameras(const Background& background, std::size_t vertex,
                                           const Eigen::Vector3d& eye_m, int cameras);

}  // namespace telepalp::mixed
