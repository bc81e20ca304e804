#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "clients/mixed/view/view.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::mixed {

/// An image of the scene without device and hand, and the camera that took it.
struct SourceImage {
  View view;
  ColorImage color;
};

/// An approximate surface of the background: triangles in the world's frame [m].
struct Proxy {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A rectangle as a grid of triangles: corner, two sides, and the number of cells along them.
[[nodiscard]] Proxy plane_proxy(const Eigen::Vector3d& corner, const Eigen::Vector3d& along,
                                const Eigen::Vector3d& across, int columns, int rows);

/// The mesh of a depth image in the world's frame: one vertex on every `step_px`-th row and column. A triangle
/// is left out if the depths of its vertices differ by more than `jump_m`, or if one of them has no depth.
[[nodiscard]] Proxy depth_proxy(const DepthImage& depth, const View& view, int step_px, double jump_m);

void append(Proxy& proxy, const Proxy& more);

/// The source images and the proxy. Computed once: which image sees which vertex, and from which direction.
class Background {
 public:
  /// Error: no image; an image whose size is not that of its intrinsics; a pose that is not finite; no triangle; a
  /// triangle with a vertex that does not exist or is not finite.
  [[nodiscard]] static Result<Background> prepare(std::vector<SourceImage> sources, Proxy proxy);

  [[nodiscard]] const std::vector<SourceImage>& sources() const noexcept { return sources_; }
  [[nodiscard]] const Proxy& proxy() const noexcept { return proxy_; }

  /// The direction from a source's camera to a vertex: unit, in the world's frame; zero if the source does not see the
  /// vertex, because it is outside the image or hidden behind the proxy.
  [[nodiscard]] const Eigen::Vector3f& direction(std::size_t vertex, std::size_t source) const noexcept {
    return directions_[vertex * sources_.size() + source];
  }

 private:
  void look_from(std::size_t source);

  std::vector<SourceImage> sources_;
  Proxy proxy_;
  std::vector<Eigen::Vector3f> directions_;
};

}  // namespace telepalp::mixed
