#pragma once

#include <string>
#include <string_view>

#include "codec/depth_stream.h"
#include "proto/words/result.h"
#include "support/program/options.h"

namespace telepalp::server {

/// What the two options are called in a program that compresses depth; `--key-every` is called so in each.
struct DepthOptionNames {
  std::string_view mode;   ///< "depth-mode"
  std::string_view bound;  ///< "depth-bound"
};

/// A bound from "LEAST_MM,PER_M2_MM": depth z [m] may move by max(LEAST_MM, PER_M2_MM * z²) millimetres; at most 100
/// and 20, for beyond that no picture is left. `option` is named in the error.
[[nodiscard]] Result<codec::DepthBound> read_depth_bound(const std::string& text, std::string_view option);

/// How depth shall be compressed. A bound for a mode that moves nothing is an error: whoever gives one expects a loss.
[[nodiscard]] Result<codec::DepthStreamSettings> read_depth_settings(const program::Arguments& arguments,
                                                                     const DepthOptionNames& names);

}  // namespace telepalp::server
