#pragma once

#include <string>

#include "proto/words/rgbd_frame.h"

namespace telepalp::export_tool {

/// The measured points of `frame` [m] in the depth camera's frame, as the bytes of a binary PLY file; with colour if
/// the frame has colour that is registered to depth.
[[nodiscard]] std::string ply_of(const RgbdFrame& frame);

/// One point for each pixel of `frame`, otherwise as ply_of(), as the bytes of an organised binary PCD file; points
/// that were not measured are NaN.
[[nodiscard]] std::string pcd_of(const RgbdFrame& frame);

}  // namespace telepalp::export_tool
