#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::bench {

/// The depth images of a recording that fit into memory.
struct DepthSet {
  std::vector<DepthImage> images;
  std::size_t left_out = 0;  ///< images beyond 1 GiB of samples
};

/// The names in a list that is separated by commas.
[[nodiscard]] std::vector<std::string> names_in(const std::string& list);

/// The depth of `input`, a file or folder as telepalp-codec reads it; of the synthetic patient if `input` is empty.
[[nodiscard]] Result<DepthSet> depth_set_of(const std::string& input);

/// True if the levels are those of a Kinect v1: about 2.85 mm apart at 1 m, and farther with the square of depth. The
/// budgets of time are for its frames: zstd takes a third of the time for an empty frame, and twice for noise.
[[nodiscard]] bool is_kinects(const DepthImage& frame);

/// Bytes of the uncompressed samples.
[[nodiscard]] double raw_bytes(const std::vector<DepthImage>& images);

}  // namespace telepalp::bench
