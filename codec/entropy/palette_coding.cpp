#include "codec/entropy/palette_coding.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "codec/entropy/level_coding.h"

namespace telepalp::codec {
namespace {

/// Calls `code(model, level)` for each level of `before` except 0. The model of a level depends on whether the level
/// below it was kept.
template <class Code>
void for_each_kept(const LevelPalette& before, Code code) {
  Model models[2] = {kFlatModel, kFlatModel};
  bool kept = true;
  for (std::size_t rank = 1; rank < before.size(); ++rank) {
    Model& model = models[kept ? 1 : 0];
    kept = code(model, before.levels[rank]);
    learn<4>(model, kept ? 1 : 0);
  }
}

/// The whole palette, with its new levels coded by a disparity law (`by_law`) or by steps; empty when no law fits.
std::string coded(const LevelPalette& palette, const LevelPalette& before, bool by_law) {
  std::string bytes(128 + 4 * (palette.size() + before.size()), '\0');
  RangeEncoder coder;
  coder.start(reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size());
  for_each_kept(before, [&](const Model& model, std::uint16_t level) {
    const bool kept = std::binary_search(palette.levels.begin(), palette.levels.end(), level);
    coder.encode(model, kept ? 1 : 0);
    return kept;
  });
  std::vector<std::uint16_t> fresh{0};
  std::set_difference(palette.levels.begin(), palette.levels.end(), before.levels.begin(), before.levels.end(),
                      std::back_inserter(fresh));
  if (!encode_levels(coder, fresh, by_law)) return {};
  bytes.resize(coder.finish());
  return bytes;
}

}  // namespace

void append_coded_palette(std::string& body, const LevelPalette& palette, const LevelPalette& before) {
  std::string bytes = coded(palette, before, false);
  const std::string by_law = coded(palette, before, true);
  if (!by_law.empty() && by_law.size() < bytes.size()) bytes = by_law;
  append_varint(body, static_cast<std::uint32_t>(bytes.size()));
  body.append(bytes);
}

std::optional<LevelPalette> read_coded_palette(ByteReader& reader, const LevelPalette& before) {
  const std::optional<std::uint32_t> size = reader.varint();
  const auto bytes = size ? reader.take(*size) : std::nullopt;
  if (!bytes) return std::nullopt;
  RangeDecoder coder;
  coder.start(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size());
  std::vector<std::uint16_t> kept;
  for_each_kept(before, [&](const Model& model, std::uint16_t level) {
    const bool is_kept = coder.decode(model) != 0;
    if (is_kept) kept.push_back(level);
    return is_kept;
  });
  const std::optional<std::vector<std::uint16_t>> fresh = decode_levels(coder);
  if (!fresh) return std::nullopt;
  LevelPalette palette{.levels = {}};
  std::merge(kept.begin(), kept.end(), fresh->begin(), fresh->end(), std::back_inserter(palette.levels));
  if (std::adjacent_find(palette.levels.begin(), palette.levels.end()) != palette.levels.end()) return std::nullopt;
  return palette;
}

}  // namespace telepalp::codec
