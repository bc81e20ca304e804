#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "codec/bytes/bytes.h"

namespace telepalp::codec {

/// The distinct depths of a frame, ascending. `levels[0]` is 0, "not measured". A pixel's rank is its index in this
/// list. A Kinect-class frame has a few hundred levels, and from rank to rank the disparity changes by one step.
struct LevelPalette {
  std::vector<std::uint16_t> levels{0};

  [[nodiscard]] std::size_t size() const noexcept { return levels.size(); }
};

/// The rank of each of the 65 536 possible samples. ranks_of() gives samples outside the palette the rank 0.
using RankOfLevel = std::vector<std::uint16_t>;

[[nodiscard]] LevelPalette palette_of(std::span<const std::uint16_t> samples);
[[nodiscard]] RankOfLevel ranks_of(const LevelPalette& palette);

/// The rank of the nearest level above 0, for a sample above 0; the lower level of two equally near. Sample 0: rank 0.
[[nodiscard]] RankOfLevel nearest_ranks_of(const LevelPalette& palette);

/// Looks up the rank of each sample.
[[nodiscard]] std::vector<std::uint16_t> ranks_by(const RankOfLevel& rank_of, std::span<const std::uint16_t> samples);

/// Writes the number of levels above 0, then, for each of them, its difference from the level before, minus one. With
/// differences, the bytes cannot express an unordered palette.
void append_palette(std::string& bytes, const LevelPalette& palette);

/// nullopt: the bytes end too soon, or a level exceeds 65 535.
[[nodiscard]] std::optional<LevelPalette> read_palette(ByteReader& reader);

}  // namespace telepalp::codec
