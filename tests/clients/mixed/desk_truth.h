#pragma once

#include "clients/mixed/background/completion.h"
#include "clients/mixed/device/device_mask.h"
#include "clients/mixed/scene/desk_props.h"

namespace telepalp::mixed {

/// A camera with small images.
inline const Intrinsics kDeskLens{320, 240, 300, 300, 159.5, 119.5};

/// An Omni on the desk, its handle held up.
[[nodiscard]] StandingDevice standing_device();

/// The device moved as a whole by `by_m` [m, world]. If that is the coupling's gap, its handle lies where the virtual
/// tool is.
[[nodiscard]] StandingDevice moved_device(StandingDevice device, const Eigen::Vector3d& by_m);

/// A mask against the true one.
struct Overlap {
  double recall = 0.0;    ///< share of the truth that the mask covers
  double too_much = 0.0;  ///< pixels of the mask outside the truth, as a share of the truth
  double iou = 0.0;       ///< intersection over union
};
[[nodiscard]] Overlap overlap_of(const Mask& mask, const Mask& truth);

/// Masks of a device whose calibration errs by a translation of 0.85 mm an axis and a rotation of 0.5 degrees rms about
/// the middle of its workspace, in random attitudes and views.
struct MaskFigures {
  double recall = 0.0;
  double least_recall = 1.0;
  double too_much = 0.0;
  double furthest_m = 0.0;  ///< 95 % quantile of the distance of the mask's outline from the truth
  double mean_m = 0.0;      ///< mean of the same distance
};
/// `arm_alone`: without base and torso, which are wide and hardly move.
[[nodiscard]] MaskFigures mask_figures(int count, const Intrinsics& lens, const MaskMargin& margin, bool arm_alone);
/// The margin of three standard deviations of the calibration error in mask_figures().
[[nodiscard]] MaskMargin expected_margin();

/// Standard deviations of the error of a camera's pose, on each axis. Each pose has its own error.
struct PoseNoise {
  double at_m = 0.0;
  double turn_rad = 0.0;
};
[[nodiscard]] Transform<World, Eye> disturbed(const Transform<World, Eye>& pose, const PoseNoise& noise,
                                              std::uint64_t seed);

/// The desk's background: `count` images within 50 cm and 90 degrees, and a proxy of planes, or of depth images.
[[nodiscard]] Background desk_background(const Intrinsics& lens, int count, ProxyKind kind, const PoseNoise& noise,
                                         bool printed_pages, int threads);

/// Peak signal-to-noise ratio [dB] of the pixels of `where`.
[[nodiscard]] double psnr_db(const ColorImage& image, const ColorImage& truth, const Mask& where);
/// Mean structural similarity of the grey levels in windows of 7 x 7 pixels with their centre in `where`; Wang et al.
/// 2004 with uniform windows.
[[nodiscard]] double ssim(const ColorImage& image, const ColorImage& truth, const Mask& where);
/// Mean absolute step of image - truth between neighbours of which one lies in `where` and the other does not [levels].
[[nodiscard]] double border_step(const ColorImage& image, const ColorImage& truth, const Mask& where);

}  // namespace telepalp::mixed
