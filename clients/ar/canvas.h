#pragma once

#include <vector>

#include "clients/ar/mesh.h"
#include "clients/ar/shadow_map.h"
#include "clients/ar/view_camera.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::ar {

/// Material of a mesh.
struct Paint {
  float opacity = 1.0F;    ///< where no mesh hides this one; with 1, it hides all meshes behind it
  float behind = 0.0F;     ///< opacity where another mesh hides it
  float shine = 0.0F;      ///< strength of the specular highlight
  float rim = 0.0F;        ///< opacity added at the silhouette, for a look of glass
  bool two_sided = false;  ///< draw back faces too
  bool takes_shadow = true;
};

/// Lights of the scene, as unit directions towards the light in the depth camera's frame.
struct Lights {
  Eigen::Vector3f key;  ///< of the main light, which casts the shadow
  Eigen::Vector3f up;   ///< of the diffuse light: a face of this normal gets most of it, the opposite face least
};

/// A software renderer with a z-buffer; it needs no graphics card. It renders 2 x 2 samples for each pixel, and
/// resolved() averages these samples in linear light.
class Canvas {
 public:
  /// Width and height: 1 to 4096. `top`, `bottom`: linear RGB of the background's upper and lower edge, blended evenly.
  Canvas(int width_px, int height_px, const Eigen::Vector3f& top, const Eigen::Vector3f& bottom);

  /// Draws `mesh` over what is drawn already. `camera`: of the finished picture; its size must be the canvas's.
  void draw(const Mesh& mesh, const ViewCamera& camera, const Lights& lights, const ShadowMap& shadow,
            const Paint& paint);

  /// The finished picture in 8-bit sRGB.
  [[nodiscard]] ColorImage resolved() const;

  /// `camera`, given for the finished picture, scaled to the supersampled pixels of this canvas, as draw() uses it.
  [[nodiscard]] ViewCamera supersampled(ViewCamera camera) const noexcept;

 private:
  static constexpr int kSamples = 2;  // samples per pixel side
  int width_;                         ///< in supersampled pixels
  int height_;
  std::vector<Eigen::Vector3f> light_;
  std::vector<float> depth_;
};

}  // namespace telepalp::ar
