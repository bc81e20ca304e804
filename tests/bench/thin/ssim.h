#pragma once

#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// Mean structural similarity of two images' luma (Rec. 601): Wang, Bovik, Sheikh, Simoncelli, IEEE Transactions on
/// Image Processing 13(4), 2004, eq. (13) with its constants, over windows of 8 x 8 pixels, 4 pixels apart. 1: equal.
/// Both are well formed, of equal size, and at least 8 pixels a side.
[[nodiscard]] double ssim(const ColorImage& a, const ColorImage& b);

}  // namespace telepalp::bench
