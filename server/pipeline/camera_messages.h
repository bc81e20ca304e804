#pragma once

#include "codec/depth.h"
#include "foxglove/CameraCalibration.pb.h"
#include "foxglove/CompressedImage.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "messages/camera.pb.h"
#include "proto/words/rgbd_frame.h"
#include "server/capture/capture_source.h"

namespace telepalp::pipeline {

/// The depth message of `frame`, compressed as `encoded`. The caller sets `encoded_ns`, because this function reads no
/// clock.
[[nodiscard]] msg::DepthImage depth_message(const RgbdFrame& frame, codec::EncodedDepth encoded);

/// The colour message of `frame`, as JPEG. `frame` is well formed and has colour.
[[nodiscard]] foxglove::CompressedImage color_message(const RgbdFrame& frame, int jpeg_quality);

/// The colour message of `frame` with the image `compressed`, whose coding is `format`.
[[nodiscard]] foxglove::CompressedImage color_message(const RgbdFrame& frame, const std::string& format,
                                                      std::string compressed);

/// The colour message of `frame` as video: the codec made `encoded` of it.
[[nodiscard]] foxglove::CompressedVideo video_message(const RgbdFrame& frame, std::string encoded);

/// The depth camera's model: an undistorted pinhole.
[[nodiscard]] foxglove::CameraCalibration calibration_message(const RgbdFrame& frame);

/// The colour camera's model, in the frame of reference that color_message() names.
[[nodiscard]] foxglove::CameraCalibration color_calibration_message(const RgbdFrame& frame);

[[nodiscard]] msg::CaptureState to_message(capture::CaptureState state) noexcept;

}  // namespace telepalp::pipeline
