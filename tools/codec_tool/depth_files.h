#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "proto/words/time.h"

namespace telepalp::codec_tool {

/// One depth image of an input, with its name.
struct NamedDepth {
  std::string name;  ///< file name, or the number of the frame
  SessionTime captured;
  DepthImage depth;
  std::optional<DepthErrorBound> loss = {};  ///< bound on its compression error, from the recording
};

/// Calls `visit` with each depth image of `input` in order, until `visit` returns an error. `input`: a 16-bit PNG, TIFF
/// or binary PGM; a directory of such files, searched recursively, in order of path, without its colour images; or a
/// .oni, .pcd or .mcap recording. `unit_m`: metres per unit of the samples in image files. Samples are passed on
/// unchanged. `pass_over` is called with an error for each undecodable image of a .mcap, and once for all damage of a
/// .oni; if `pass_over` is empty, the error ends the call. A .oni without a readable image is always an error.
[[nodiscard]] Result<void> for_each_depth(const std::filesystem::path& input, double unit_m,
                                          const std::function<Result<void>(NamedDepth)>& visit,
                                          const std::function<void(const Error&)>& pass_over = {});

/// Number of image files that for_each_depth() will open, with colour or depth; 0 if `input` is not a folder.
[[nodiscard]] std::size_t count_depth_files(const std::filesystem::path& input);

}  // namespace telepalp::codec_tool
