#pragma once

#include <array>

#include "haptic_station/surface/build/patch_registration.h"
#include "haptic_station/surface/snapshot/skin_mark.h"

namespace telepalp::surface {

/// Follows places on the skin from image to image, each against the patch that was seen there first, so that nothing
/// drifts. Where the patch is hidden, or has too little shape to tell a slide, the last values are held and the mark
/// says so. Owner: surface thread.
class MarkTracker {
 public:
  /// The places to follow from now on; forgets those of before.
  void watch(const MarkLines& lines);
  /// Forgets the patches, but not where to find them.
  void restart();

  /// The next frame, `dt_s` after the last. `averaged`: over time, from which a patch is taken; `seen`: this frame's.
  void add(const DepthField& averaged, const DepthField& seen, const Intrinsics& camera, double dt_s);

  [[nodiscard]] const SkinMarks& marks() const noexcept { return marks_; }

 private:
  struct Followed {
    std::optional<MarkLine> line;
    int frames = 0;  ///< seen while the patch is not known yet
    std::optional<SkinPatch> patch;
    PatchPose pose;                                    ///< as last registered, with the filtered slide
    Eigen::Vector3d slid_m = Eigen::Vector3d::Zero();  ///< part of the motion along the skin
  };

  static void begin(Followed& one, SkinMark& mark, const DepthField& averaged, const Intrinsics& camera);
  static void follow(Followed& one, SkinMark& mark, const DepthField& seen, const Intrinsics& camera, double dt_s);

  std::array<Followed, kMostMarks> followed_;
  SkinMarks marks_{};
};

}  // namespace telepalp::surface
