#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "codec/bytes/bytes.h"

namespace telepalp::codec {

/// The distinct depths of a frame, ascending; a pixel is then its rank in this list. `levels[0]` is 0, "not measured".
/// A Kinect-class frame has a few hundred: neighbouring ranks are neighbouring disparities, whatever the distance.
struct LevelPalette {
  std::vector<std::uint16_t> levels{0};

  [[nodiscard]] std::size_t size() const noexcept { return levels.size(); }
};

/// Rank of each of the 65 536 possible samples; only those in the palette mean anything.
using RankOfLevel = std::vector<std::uint16_t>;

[[nodiscard]] LevelPalette palette_of(std::span<const std::uint16_t> samples);
[[nodiscard]] RankOfLevel ranks_of(const LevelPalette& palette);

/// The same for any sample: the rank of the level nearest to it, the lower of two as near; 0 only for 0.
[[nodiscard]] RankOfLevel nearest_ranks_of(const LevelPalette& palette);

/// `samples` by such a table.
[[nodiscard]] std::vector<std::uint16_t> ranks_by(const RankOfLevel& rank_of, std::span<const std::uint16_t> samples);

/// Writes the count, then each step to the next level less one. Why steps: an order that is wrong cannot be written.
void append_palette(std::string& bytes, const LevelPalette& palette);

/// nullopt when the bytes end too soon, or a level passes 65 535.
[[nodiscard]] std::optional<LevelPalette> read_palette(ByteReader& reader);

}  // namespace telepalp::codec
