#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"

namespace telepalp::server {

/// One depth image of an input, and what it is called there.
struct NamedDepth {
  std::string name;  ///< file name, or the number of the frame
  SessionTime captured;
  DepthImage depth;
  std::optional<DepthLoss> loss = {};  ///< that a recording tells of it
};

/// Gives each depth image of `input` to `visit`, in order, until one is refused: a 16-bit PNG, TIFF or binary PGM; a
/// directory of these, at any depth, sorted by path, colour images passed over; a .oni, .pcd or .mcap recording. Image
/// files do not say their unit: `unit_m` is taken. Samples are given as they lie, none is ignored.
/// What cannot be decoded in an .mcap, and what is damaged in a .oni, is told to `pass_over`; without one, it is an
/// error.
[[nodiscard]] Result<void> for_each_depth(const std::filesystem::path& input, double unit_m,
                                          const std::function<Result<void>(NamedDepth)>& visit,
                                          const std::function<void(const Error&)>& pass_over = {});

/// How many images that will be; 0 when only reading tells.
[[nodiscard]] std::size_t count_depth_files(const std::filesystem::path& input);

}  // namespace telepalp::server
