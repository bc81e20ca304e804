#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "codec/depth_stream.h"
#include "proto/words/result.h"

namespace telepalp::server {

// What telepalp-codec does; each command prints its figures to stdout and how far it is to a terminal.

/// Compresses the depth images of `input`, as for_each_depth() finds them, into the session file `output`.
[[nodiscard]] Result<void> encode_recording(const std::filesystem::path& input, const std::filesystem::path& output,
                                            const codec::DepthStreamSettings& settings, double unit_m);

/// Writes each depth image of `input` to `folder` as a numbered file of `kind`, "png" or "pgm". An image that cannot be
/// read leaves its number out; an error at the end then, when all others are written.
[[nodiscard]] Result<void> decode_recording(const std::filesystem::path& input, const std::filesystem::path& folder,
                                            const std::string& kind);

/// Says how each depth image of the session file `input` is compressed, without decoding any; `json`: for programs.
[[nodiscard]] Result<void> describe_recording(const std::filesystem::path& input, bool json);

/// Says how far the depth images of `second` lie from those of `first`. With a `bound`: an error unless every pixel
/// keeps it, and what was measured still is, and nothing else.
[[nodiscard]] Result<void> compare_recordings(const std::filesystem::path& first, const std::filesystem::path& second,
                                              double unit_m, const std::optional<codec::DepthBound>& bound = {});

}  // namespace telepalp::server
