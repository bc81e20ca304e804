#pragma once

#include <cstdint>
#include <vector>

#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Ranks (indices in a palette of depths) of a whole frame, rows from top to bottom; 0 is "not measured".
using Ranks = std::vector<std::uint16_t>;

/// A frame as ranks of a palette; in near-lossless coding, as ranges of ranks.
struct RankedFrame {
  LevelPalette palette;
  Ranks ranks;
  /// Empty: lossless. Else the greatest rank that each pixel may take, where `ranks` has the least. 65 535 for pixels
  /// that were not measured, so that they can take any rank of their neighbours.
  Ranks most = {};
};

/// A frame for lossless coding.
[[nodiscard]] inline RankedFrame ranked(LevelPalette palette, std::span<const std::uint16_t> samples) {
  Ranks ranks = ranks_by(ranks_of(palette), samples);
  return {.palette = std::move(palette), .ranks = std::move(ranks)};
}

}  // namespace telepalp::codec
