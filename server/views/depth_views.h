#pragma once

#include "foxglove/PointCloud.pb.h"
#include "foxglove/RawImage.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::views {

/// `depth` as a 16-bit image in millimetres (16UC1), 0 where depth is not measured or exceeds 65.535 m.
[[nodiscard]] foxglove::RawImage depth_view(const DepthImage& depth, SessionTime captured);

/// The measured points of `frame` [m] in the depth camera's frame, with their colours if the frame has colour: a point
/// then has the fields red, green, blue and alpha, too. An image of more than 500 000 pixels is subsampled by rows and
/// columns. `frame` is well formed.
[[nodiscard]] foxglove::PointCloud cloud_view(const RgbdFrame& frame);

}  // namespace telepalp::views
