#include "codec/levels/level_palette.h"

#include <bit>
#include <cstring>

namespace telepalp::codec {
namespace {

constexpr std::size_t kSamples = 65536;

}  // namespace

LevelPalette palette_of(std::span<const std::uint16_t> samples) {
  std::vector<std::uint8_t> seen(kSamples);
  for (const std::uint16_t sample : samples) seen[sample] = 1;
  seen[0] = 0;  // sample 0 is in every palette already
  LevelPalette palette;
  palette.levels.reserve(512);
  for (std::size_t level = 0; level < kSamples; level += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &seen[level], sizeof eight);
    for (; eight != 0; eight &= eight - 1)
      palette.levels.push_back(
          static_cast<std::uint16_t>(level + static_cast<std::size_t>(std::countr_zero(eight)) / 8));
  }
  return palette;
}

RankOfLevel ranks_of(const LevelPalette& palette) {
  RankOfLevel rank_of(kSamples);
  for (std::size_t rank = 0; rank < palette.size(); ++rank)
    rank_of[palette.levels[rank]] = static_cast<std::uint16_t>(rank);
  return rank_of;
}

RankOfLevel nearest_ranks_of(const LevelPalette& palette) {
  RankOfLevel rank_of(kSamples);
  std::size_t sample = 1;
  for (std::size_t rank = 1; rank < palette.size(); ++rank) {
    const std::size_t last =
        rank + 1 < palette.size() ? (std::size_t{palette.levels[rank]} + palette.levels[rank + 1]) / 2 : kSamples - 1;
    for (; sample <= last; ++sample) rank_of[sample] = static_cast<std::uint16_t>(rank);
  }
  return rank_of;
}

std::vector<std::uint16_t> ranks_by(const RankOfLevel& rank_of, std::span<const std::uint16_t> samples) {
  std::vector<std::uint16_t> ranks(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) ranks[i] = rank_of[samples[i]];
  return ranks;
}

void append_palette(std::string& bytes, const LevelPalette& palette) {
  append_varint(bytes, static_cast<std::uint32_t>(palette.size() - 1));
  for (std::size_t rank = 1; rank < palette.size(); ++rank)
    append_varint(bytes, static_cast<std::uint32_t>(palette.levels[rank] - palette.levels[rank - 1] - 1));
}

std::optional<LevelPalette> read_palette(ByteReader& reader) {
  const std::optional<std::uint32_t> count = reader.varint();
  if (!count || *count >= kSamples || *count > reader.rest().size()) return std::nullopt;
  LevelPalette palette;
  palette.levels.reserve(*count + 1);
  for (std::uint32_t i = 0; i < *count; ++i) {
    const std::optional<std::uint32_t> step = reader.varint();
    if (!step || *step + palette.levels.back() + 1 >= kSamples || *step >= kSamples) return std::nullopt;
    palette.levels.push_back(static_cast<std::uint16_t>(*step + palette.levels.back() + 1));
  }
  return palette;
}

}  // namespace telepalp::codec
