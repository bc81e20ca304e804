#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "codec/depth_stream.h"
#include "proto/words/result.h"

namespace telepalp::codec_tool {

// The commands of telepalp-codec. They print results to stdout. Encoding and decoding show progress on a terminal.

/// Compresses the depth images of `input` into the session file `output`. `input`, here and in compare_recordings(): an
/// image file, a folder of such files, or a recording (.oni, .pcd, .mcap). `unit_m`: metres per unit of image files.
[[nodiscard]] Result<void> encode_recording(const std::filesystem::path& input, const std::filesystem::path& output,
                                            const codec::DepthStreamSettings& settings, double unit_m);

/// Writes each depth image of `input` to `folder` as a numbered file of `kind`, "png" or "pgm". An unreadable image
/// leaves a gap in the numbers; after the last image, an error then states how many images were unreadable.
[[nodiscard]] Result<void> decode_recording(const std::filesystem::path& input, const std::filesystem::path& folder,
                                            const std::string& kind);

/// Prints how each depth image of the session file `input` is compressed, without decoding it. `json`: print JSON.
[[nodiscard]] Result<void> describe_recording(const std::filesystem::path& input, bool json);

/// Prints the differences between the depth images of `first` and `second`. Error: their numbers or sizes differ; or,
/// with a `bound`, a pixel differs by more than the bound, or is measured in one image only.
[[nodiscard]] Result<void> compare_recordings(const std::filesystem::path& first, const std::filesystem::path& second,
                                              double unit_m, const std::optional<DepthErrorBound>& bound = {});

}  // namespace telepalp::codec_tool
