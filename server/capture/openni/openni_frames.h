#pragma once

#include <OpenNI.h>

#include <optional>

#include "proto/words/rgbd_frame.h"

namespace telepalp::server {

/// The driver's frame as our image; nullopt when it has a size, a stride or a format that we do not take.
[[nodiscard]] std::optional<DepthImage> depth_image(const openni::VideoFrameRef& frame);
[[nodiscard]] std::optional<ColorImage> color_image(const openni::VideoFrameRef& frame);

/// Pinhole intrinsics from the fields of view that the driver states; `color` may be invalid.
[[nodiscard]] CameraModel camera_of(openni::Device& device, const openni::VideoStream& depth,
                                    const openni::VideoStream& color);

/// Sets the mode nearest to 640x480 at 30 Hz in `format`; leaves the stream as it is when it has none in that format.
void choose_mode(openni::VideoStream& stream, openni::PixelFormat format);

}  // namespace telepalp::server
