#include "codec/palette_coding.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "codec/range_coder.h"

namespace telepalp::codec {
namespace {

constexpr std::uint32_t kLevels = 65536;
constexpr int kSmallChange = 6;
constexpr int kLargeChange = 14;  // a number follows: the step itself

/// The models of a palette, and the step before.
struct PaletteModels {
  Model count = kFlatModel;
  Model step = kFlatModel;
  Model change = kFlatModel;
  std::uint32_t step_before = 0;
};

int change_symbol(std::uint32_t step, std::uint32_t before) noexcept {
  const auto change = static_cast<std::int64_t>(step) - before;
  if (change < -kSmallChange || change > kSmallChange) return kLargeChange;
  return static_cast<int>(change) + kSmallChange;
}

/// Calls `code(model, level)` for each level of `before` but 0. Whether a level is kept is told by whether the one
/// below it was.
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

void encode_levels(RangeEncoder& coder, std::span<const std::uint16_t> levels) {
  PaletteModels models;
  encode_number(coder, models.count, static_cast<std::uint32_t>(levels.size() - 1));
  for (std::size_t rank = 1; rank < levels.size(); ++rank) {
    const auto step = static_cast<std::uint32_t>(levels[rank] - levels[rank - 1] - 1);
    const int symbol = change_symbol(step, models.step_before);
    coder.encode(models.change, symbol);
    learn<4>(models.change, symbol);
    if (symbol == kLargeChange) encode_number(coder, models.step, step);
    models.step_before = step;
  }
}

std::optional<LevelPalette> decode_levels(RangeDecoder& coder) {
  PaletteModels models;
  const std::uint32_t count = decode_number(coder, models.count);
  if (count >= kLevels) return std::nullopt;
  LevelPalette palette;
  palette.levels.reserve(count + 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    const int symbol = coder.decode(models.change);
    learn<4>(models.change, symbol);
    const std::int64_t step = symbol == kLargeChange ? std::int64_t{decode_number(coder, models.step)}
                                                     : std::int64_t{models.step_before} + symbol - kSmallChange;
    const std::int64_t level = palette.levels.back() + 1 + step;
    if (step < 0 || level >= std::int64_t{kLevels}) return std::nullopt;
    palette.levels.push_back(static_cast<std::uint16_t>(level));
    models.step_before = static_cast<std::uint32_t>(step);
  }
  return palette;
}

}  // namespace

void append_coded_palette(std::string& body, const LevelPalette& palette, const LevelPalette& before) {
  std::string bytes(64 + 4 * (palette.size() + before.size()), '\0');
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
  encode_levels(coder, fresh);
  bytes.resize(coder.finish());
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
  std::optional<LevelPalette> palette = decode_levels(coder);
  if (!palette) return std::nullopt;
  std::vector<std::uint16_t> all;
  std::merge(kept.begin(), kept.end(), palette->levels.begin(), palette->levels.end(), std::back_inserter(all));
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return std::nullopt;
  palette->levels = std::move(all);
  return palette;
}

}  // namespace telepalp::codec
