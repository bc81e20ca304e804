#pragma once

#include "clients/ar/mesh.h"
#include "clients/ar/view_camera.h"

namespace telepalp::ar {

/// How well a camera shows the place that is touched.
struct ViewQuality {
  float seen = 0.0F;    ///< share of the skin around the touch that no other part of the body hides
  float facing = 0.0F;  ///< mean cosine between this skin's normal and the direction to the eye; 0: edge on
  float filled = 0.0F;  ///< share of the middle of the picture in which a measured surface is seen, not a hole

  [[nodiscard]] bool is_good() const noexcept { return seen > 0.85F && facing > 0.4F && filled > 0.8F; }
  [[nodiscard]] float score() const noexcept { return seen * facing * filled; }
};

/// The quality of `camera` for the touch at `target`, in `body`, whose vertices are those of a depth image.
[[nodiscard]] ViewQuality quality_of(const ViewCamera& camera, const Mesh& body, const Eigen::Vector3f& target);

/// A three-quarter view of `target`: above and behind the doctor's hand, from the patient's side. The first of several
/// directions that shows the touch well; if none does, the best of them. The last direction is the depth camera's own:
/// from there nothing is hidden, but the depth of the scene is not seen.
[[nodiscard]] ViewCamera chosen_view(const Mesh& body, const Eigen::Vector3f& target, float distance_m, int width_px,
                                     int height_px);

}  // namespace telepalp::ar
