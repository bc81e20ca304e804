#pragma once

#include <OpenNI.h>

#include <optional>

#include "proto/words/rgbd_frame.h"

namespace telepalp::capture {

/// Converts a driver's frame; nullopt when its size, stride or format is not supported.
[[nodiscard]] std::optional<DepthImage> depth_image(const openni::VideoFrameRef& frame);
[[nodiscard]] std::optional<ColorImage> color_image(const openni::VideoFrameRef& frame);

/// Pinhole intrinsics from the driver's fields of view. `color` is an invalid stream if the camera has no colour.
[[nodiscard]] CameraModel camera_of(openni::Device& device, const openni::VideoStream& depth,
                                    const openni::VideoStream& color);

/// Sets the video mode with `format` that is nearest to 640 × 480 at 30 Hz; does nothing if no mode has this format.
void choose_mode(openni::VideoStream& stream, openni::PixelFormat format);

}  // namespace telepalp::capture
