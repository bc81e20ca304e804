#pragma once

#include <string>
#include <string_view>

#include "codec/depth_stream.h"
#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::pipeline {

/// Names of a program's options for depth compression. The third option is `--key-every` in every program.
struct DepthOptionNames {
  std::string_view mode;   ///< "depth-mode" of telepalp-server, "mode" of telepalp-codec
  std::string_view bound;  ///< "depth-bound" of telepalp-server, "bound" of telepalp-codec
};

/// Parses "LEAST_MM,PER_M2_MM": the error of depth z [m] is at most max(LEAST_MM, PER_M2_MM * z²) millimetres. Error:
/// LEAST_MM is above 100 or PER_M2_MM above 20, which would destroy the image. `option`: the option's name, for errors.
[[nodiscard]] Result<DepthErrorBound> read_depth_bound(const std::string& text, std::string_view option);

/// Reads the settings of the depth encoder. Error: a bound together with a lossless mode, because the user then expects
/// near-lossless coding.
[[nodiscard]] Result<codec::DepthStreamSettings> read_depth_settings(const program::Arguments& arguments,
                                                                     const DepthOptionNames& names);

}  // namespace telepalp::pipeline
