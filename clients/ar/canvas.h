#pragma once

#include <vector>

#include "clients/ar/mesh.h"
#include "clients/ar/shadow_map.h"
#include "clients/ar/view_camera.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// How a mesh is painted.
struct Paint {
  float opacity = 1.0F;    ///< where it is in front of all else; at 1 it also hides what comes behind it
  float behind = 0.0F;     ///< opacity where something hides it: how it shimmers through
  float shine = 0.0F;      ///< strength of the highlight
  float rim = 0.0F;        ///< opacity added at the silhouette: glass
  bool two_sided = false;  ///< seen from behind too; else only faces whose normal looks at the eye
  bool takes_shadow = true;
};

/// Lights of the scene, directions towards them, unit, in the depth camera's frame.
struct Lights {
  Eigen::Vector3f key;
  Eigen::Vector3f up;
};

/// An image with a z-buffer that meshes are drawn on by the processor: no graphics card is asked for. Drawn at twice
/// the size in each direction and averaged at the end, in linear light.
class Canvas {
 public:
  Canvas(int width_px, int height_px, const Eigen::Vector3f& top, const Eigen::Vector3f& bottom);

  void draw(const Mesh& mesh, const ViewCamera& camera, const Lights& lights, const ShadowMap& shadow,
            const Paint& paint);

  /// The finished picture, 8-bit sRGB.
  [[nodiscard]] ColorImage resolved() const;

  /// The camera for this canvas' own pixels.
  [[nodiscard]] ViewCamera supersampled(ViewCamera camera) const noexcept;

 private:
  static constexpr int kSamples = 2;  // a side
  int width_;                         ///< in samples
  int height_;
  std::vector<Eigen::Vector3f> light_;
  std::vector<float> depth_;
};

}  // namespace telepalp::ar
