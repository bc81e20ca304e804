#pragma once

#include <cstdint>
#include <vector>

#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Ranks of a whole frame, rows from top to bottom; 0 is "not measured".
using Ranks = std::vector<std::uint16_t>;

/// A frame in ranks of a palette: those it has, or those it may have.
struct RankedFrame {
  LevelPalette palette;
  Ranks ranks;
  /// Empty; or the last rank that each pixel may have, of which `ranks` has the first. 65 535 where nothing was
  /// measured, so that whoever asks whether a pixel could be like its neighbour is not held up by it.
  Ranks most = {};
};

/// As it is.
[[nodiscard]] inline RankedFrame ranked(LevelPalette palette, std::span<const std::uint16_t> samples) {
  Ranks ranks = ranks_by(ranks_of(palette), samples);
  return {.palette = std::move(palette), .ranks = std::move(ranks)};
}

}  // namespace telepalp::codec
