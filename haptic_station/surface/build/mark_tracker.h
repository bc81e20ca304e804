#pragma once

#include <array>

#include "haptic_station/surface/build/patch_registration.h"
#include "haptic_station/surface/snapshot/skin_mark.h"

namespace telepalp::surface {

/// Radius of the patch of skin by which a place is found again in each image. A wider patch shows a slide better; a
/// narrower one follows the rise of its own place better (docs/accuracy.md has both).
inline constexpr double kMarkRadius_m = 0.13;

/// Follows places on the skin from image to image. Each image is registered with the patch of skin around the place as
/// the patch was first seen, so that errors do not accumulate. While the patch is hidden, its last displacement is
/// held, and SkinMark::seen is false. While the patch is too smooth to show its tangential motion (slide), its last
/// slide is held, and SkinMark::slide_seen is false. Owner: surface thread.
class MarkTracker {
 public:
  /// `radius_m`: of the patches.
  explicit MarkTracker(double radius_m = kMarkRadius_m) : radius_m_(radius_m) {}

  /// Sets the places to follow from now on: where these lines cross the skin. Forgets the earlier places.
  void watch(const MarkLines& lines);
  /// Forgets the patches. New patches are taken on the same lines.
  void restart();

  /// Adds a frame, `dt_s` after the last frame. `averaged`: depth averaged over time, from which a patch is taken;
  /// `seen`: depth of this frame alone, with which the patch is registered.
  void add(const DepthField& averaged, const DepthField& seen, const Intrinsics& camera, double dt_s);

  [[nodiscard]] const SkinMarks& marks() const noexcept { return marks_; }

 private:
  struct Followed {
    std::optional<MarkLine> line;
    int frames = 0;  ///< number of frames without patch; from the tenth on, begin() tries to take it
    std::optional<SkinPatch> patch;
    PatchPose pose;  ///< result of the last registration, with the low-pass filtered slide
    Eigen::Vector3d slid_m = Eigen::Vector3d::Zero();  ///< part of the displacement tangential to the skin
  };

  void begin(Followed& one, SkinMark& mark, const DepthField& averaged, const Intrinsics& camera) const;
  static void follow(Followed& one, SkinMark& mark, const DepthField& seen, const Intrinsics& camera, double dt_s);

  double radius_m_;
  std::array<Followed, kMostMarks> followed_;
  SkinMarks marks_{};
};

}  // namespace telepalp::surface
