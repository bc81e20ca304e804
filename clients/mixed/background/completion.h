#pragma once

#include <optional>

#include "clients/mixed/background/background.h"
#include "clients/mixed/view/mask.h"

namespace telepalp::mixed {

struct CompletionSettings {
  /// Source images per vertex, 1 to 4. Paper S3 takes 1; several are blended with the weights of choose_cameras().
  int cameras_a_vertex = 1;
  int ring_px = 12;  ///< width of the ring around the emptied region; it blends background and live image
};

/// The background as a camera would see it: an image of the live image's size, valid where `known` is on.
struct Synthesis {
  ColorImage color;
  Mask known;
};

/// Synthesises the background at the pixels of `region`, by view-dependent texture mapping: each vertex of the proxy
/// takes the source image that sees it from the direction most like the view's, and each pixel blends the source images
/// of its triangle's vertices. A pixel that no triangle covers, or that no source image shows, stays unknown. Source:
/// paper S3 (docs/sources.md) 6.2 and 6.3, after Buehler's unstructured lumigraph and Debevec's texture mapping.
/// Directions are compared in the world's frame.
[[nodiscard]] Synthesis synthesise(const Background& background, const View& view, const Mask& region,
                                   const CompletionSettings& settings = {});

/// `mask`, enlarged by the ring of `ring_px` around it.
[[nodiscard]] Mask with_ring(const Mask& mask, int ring_px);

/// Paints `background` over the pixels of `emptied`, and blends it with the live image in the ring around them. Pixels
/// of unknown background keep the live image.
void paint_background(ColorImage& image, const Synthesis& background, const Mask& emptied, int ring_px);

/// Mean absolute difference of live image and background in the ring around `emptied` [levels]. The device does not
/// cover the ring, so the difference grows when the background has changed since its images were taken. nullopt if the
/// background is unknown in the whole ring.
[[nodiscard]] std::optional<double> ring_difference(const ColorImage& live, const Synthesis& background,
                                                    const Mask& emptied, int ring_px);

/// A larger ring_difference() means that the background has changed or that the camera's pose is wrong [levels].
inline constexpr double kChangedRing_levels = 12.0;

}  // namespace telepalp::mixed
