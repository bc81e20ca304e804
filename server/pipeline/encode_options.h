#pragma once

#include <cstddef>

#include "codec/depth_stream.h"
#include "server/plan/grade.h"

namespace telepalp::pipeline {

struct EncodeOptions {
  codec::DepthStreamSettings depth{.mode = codec::DepthMode::Fast, .key_every = 12};
  int jpeg_quality = 85;
  int video_kbit_per_s = plan::kFullVideo_kbit_per_s;  ///< target rate of colour as video
};

/// `asked`, made smaller for a line that other flows use (link::ContentLevel). Level 1: fast depth becomes intra, which
/// is as exact, and colour loses quality, as pictures and as video. From level 2: colour loses more, and near-lossless
/// depth has twice the bound.
[[nodiscard]] EncodeOptions shrunk(EncodeOptions asked, std::size_t level) noexcept;

/// `asked`, made smaller as `settings` say.
[[nodiscard]] EncodeOptions with(EncodeOptions asked, const plan::ImageSettings& settings) noexcept;

}  // namespace telepalp::pipeline
