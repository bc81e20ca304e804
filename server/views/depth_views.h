#pragma once

#include "foxglove/PointCloud.pb.h"
#include "foxglove/RawImage.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::views {

/// `depth` as a 16-bit image in millimetres (16UC1), 0 where depth is not measured or exceeds 65.535 m.
[[nodiscard]] foxglove::RawImage depth_view(const DepthImage& depth, SessionTime captured);

/// The measured points of `depth` [m] in the depth camera's frame; `camera` has the image's size. An image of more than
/// 500 000 pixels is subsampled by rows and columns.
[[nodiscard]] foxglove::PointCloud cloud_view(const DepthImage& depth, const Intrinsics& camera, SessionTime captured);

}  // namespace telepalp::views
