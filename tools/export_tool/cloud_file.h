#pragma once

#include <string>

#include "proto/words/rgbd_frame.h"

namespace telepalp::export_tool {

/// The measured points of `frame` [m] in the depth camera's frame, as the bytes of a binary PLY file; with colour if
/// the frame has colour that is registered to depth.
[[nodiscard]] std::string ply_of(const RgbdFrame& frame);

/// One point for each pixel of `frame`, as the bytes of an organised binary PCD file; NaN for pixels that were not
/// measured. Unit, frame of reference and colour are those of ply_of().
[[nodiscard]] std::string pcd_of(const RgbdFrame& frame);

}  // namespace telepalp::export_tool
