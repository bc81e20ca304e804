#pragma once

#include "clients/mixed/hand/hand_colour.h"
#include "clients/mixed/hand/morphology.h"
#include "clients/mixed/view/mask.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::mixed {

/// The colours of every fifth pixel that is on in `where`, for fit_hand_colour().
[[nodiscard]] std::vector<Rgb> colors_of(const ColorImage& image, const Mask& where);

/// The hand by its colour alone, cleaned. Paper S3 (docs/sources.md) 5.3.
[[nodiscard]] Mask hand_by_colour(const ColorImage& live, const HandColourTable& hand, const CleanUp& how);

struct DifferenceSettings {
  /// A pixel's difference from the background: mean of its channels' absolute differences [levels]. Above `sure_levels`
  /// the pixel is not background. Above `least_levels` it is not background if a path of such pixels joins it to one
  /// above `sure_levels`. Skin before wood differs by little.
  int sure_levels = 24;
  int least_levels = 8;
  double hand_threshold = 3.0;  ///< Mahalanobis distance up to which a pixel within the device's mask is the hand's
  CleanUp clean_up = {};
};

/// The hand by its difference from the background, so that it needs no glove. Outside the device's mask each pixel that
/// differs from the background is the hand. Within the mask, hand and device both differ, so the hand's colour decides:
/// it is fitted for this image to the hand's pixels outside the mask. `background`: the completed background, valid
/// where `known` is on.
[[nodiscard]] Mask hand_before_background(const ColorImage& live, const ColorImage& background, const Mask& known,
                                          const Mask& device, const DifferenceSettings& settings);

}  // namespace telepalp::mixed
