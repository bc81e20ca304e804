#pragma once

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "codec/entropy/range_coder.h"
#include "codec/levels/disparity_law.h"

// Range coding of the levels of a palette: the distinct depths of a frame, ascending. Internal linkage, as in
// range_coder.h, whose types the functions use.

namespace telepalp::codec {
namespace {

using Levels = std::vector<std::uint16_t>;

constexpr std::int64_t kLevels = 65536;

// Alphabet for coding by steps, the differences of successive levels minus 1: a symbol is the change from the
// previous step.
constexpr int kSmallChange = 6;
constexpr int kLargeChange = 14;  // escape: the step itself follows as a number

// Alphabet for coding by a DisparityLaw, which predicts a level for each disparity step. A symbol states, for one
// disparity step, that there is no level, or the offset of the level from the predicted one.
constexpr int kAbsent = 0;
constexpr int kOnLaw = 7;
constexpr int kLargestMiss = 6;
constexpr int kLawRate = 4;

/// The initial model: most disparity steps have a level exactly where the law predicts it.
constexpr Model kLawModel = [] {
  Model model{};
  constexpr int kShares[kSymbols] = {6000, 40, 40, 40, 60, 200, 1500, 23000, 1500, 200, 60, 40, 40, 40, 7};
  int below = 0;
  for (int symbol = 0; symbol <= kSymbols; ++symbol) {
    model.cdf[symbol] = static_cast<std::uint16_t>(below);
    if (symbol < kSymbols) below += kShares[symbol];
  }
  return model;
}();
static_assert(kLawModel.cdf[kSymbols] == kModelTotal);

/// Codes a number's bytes without a model.
void encode_bytes(RangeEncoder& coder, std::uint64_t value, int bytes) {
  for (int byte = bytes - 1; byte >= 0; --byte)
    coder.encode_bits(static_cast<std::uint32_t>(value >> (8 * byte)) & 0xff, 8);
}

std::uint64_t decode_bytes(RangeDecoder& coder, int bytes) {
  std::uint64_t value = 0;
  for (int byte = 0; byte < bytes; ++byte) value = value << 8 | coder.decode_bits(8);
  return value;
}

void encode_steps(RangeEncoder& coder, const Levels& levels) {
  Model count = kFlatModel;
  Model large = kFlatModel;
  Model changes = kFlatModel;
  std::int64_t before = 0;
  encode_number(coder, count, static_cast<std::uint32_t>(levels.size() - 1));
  for (std::size_t rank = 1; rank < levels.size(); ++rank) {
    const std::int64_t step = levels[rank] - levels[rank - 1] - 1;
    const std::int64_t change = step - before;
    const bool is_small = change >= -kSmallChange && change <= kSmallChange;
    const int symbol = is_small ? static_cast<int>(change) + kSmallChange : kLargeChange;
    coder.encode(changes, symbol);
    learn<4>(changes, symbol);
    if (!is_small) encode_number(coder, large, static_cast<std::uint32_t>(step));
    before = step;
  }
}

std::optional<Levels> decode_steps(RangeDecoder& coder) {
  Model count_model = kFlatModel;
  Model large = kFlatModel;
  Model changes = kFlatModel;
  const std::uint32_t count = decode_number(coder, count_model);
  if (count >= kLevels) return std::nullopt;
  Levels levels{0};
  levels.reserve(count + 1);
  std::int64_t before = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const int symbol = coder.decode(changes);
    learn<4>(changes, symbol);
    const std::int64_t step =
        symbol == kLargeChange ? std::int64_t{decode_number(coder, large)} : before + symbol - kSmallChange;
    const std::int64_t level = levels.back() + 1 + step;
    if (step < 0 || level >= kLevels) return std::nullopt;
    levels.push_back(static_cast<std::uint16_t>(level));
    before = step;
  }
  return levels;
}

/// Codes one symbol for each disparity step of `law`, farthest first. `law_levels` receives the levels that the symbols
/// express.
void encode_by_law(RangeEncoder& coder, const DisparityLaw& law, const Levels& levels, Levels& law_levels) {
  encode_bytes(coder, law.farthest, 6);
  encode_bytes(coder, law.step, 4);
  const std::uint32_t last = law.step_of(levels[1]);
  encode_bytes(coder, last, 2);
  Model models[2] = {kLawModel, kLawModel};
  bool present = true;
  auto level = levels.rbegin();
  for (std::uint32_t n = 0; n <= last; ++n) {
    const auto lawful = static_cast<std::int64_t>(law.level_at(n));
    int symbol = kAbsent;
    // encode_steps() codes the levels that this loop skips.
    for (; *level != 0 && law.step_of(*level) == n; ++level) {
      const std::int64_t miss = *level - lawful;
      if (symbol != kAbsent || miss < -kLargestMiss || miss > kLargestMiss) continue;
      symbol = kOnLaw + static_cast<int>(miss);
      law_levels.push_back(*level);
    }
    Model& model = models[present ? 1 : 0];
    coder.encode(model, symbol);
    learn<kLawRate>(model, symbol);
    present = symbol != kAbsent;
  }
  std::reverse(law_levels.begin(), law_levels.end());
}

/// The levels in ascending order; nullopt: the bytes are damaged.
std::optional<Levels> decode_by_law(RangeDecoder& coder) {
  DisparityLaw law;
  law.farthest = decode_bytes(coder, 6);
  law.step = static_cast<std::uint32_t>(decode_bytes(coder, 4));
  const auto last = static_cast<std::uint32_t>(decode_bytes(coder, 2));
  if (law.farthest == 0 || law.farthest > DisparityLaw::kOne || law.step == 0) return std::nullopt;
  Model models[2] = {kLawModel, kLawModel};
  bool present = true;
  Levels levels;
  for (std::uint32_t n = 0; n <= last; ++n) {
    Model& model = models[present ? 1 : 0];
    const int symbol = coder.decode(model);
    learn<kLawRate>(model, symbol);
    present = symbol != kAbsent;
    if (!present) continue;
    const std::int64_t level = static_cast<std::int64_t>(law.level_at(n)) + symbol - kOnLaw;
    if (level < 1 || level >= (levels.empty() ? kLevels : std::int64_t{levels.back()})) return std::nullopt;
    levels.push_back(static_cast<std::uint16_t>(level));
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

/// The grain: the greatest common divisor of all levels, at least 1.
std::uint16_t grain_of(std::span<const std::uint16_t> levels) noexcept {
  std::uint16_t grain = 0;
  for (const std::uint16_t level : levels) grain = std::gcd(grain, level);
  return std::max<std::uint16_t>(grain, 1);
}

/// Range-codes ascending levels that begin with 0, as multiples of their grain. With `by_law`: first the levels within
/// kLargestMiss of a DisparityLaw's prediction, then the others by the steps between levels. Without: all by steps.
/// Returns false, and writes nothing, if no law fits.
bool encode_levels(RangeEncoder& coder, std::span<const std::uint16_t> levels, bool by_law) {
  const std::uint16_t grain = grain_of(levels);
  Levels rest(levels.begin(), levels.end());
  for (std::uint16_t& level : rest) level = static_cast<std::uint16_t>(level / grain);
  const auto law = by_law ? fit_disparity_law(std::span(rest).subspan(1)) : std::nullopt;
  if (by_law && !law) return false;
  Model grain_model = kFlatModel;
  encode_number(coder, grain_model, grain);
  coder.encode_bits(by_law ? 1 : 0, 1);
  if (law) {
    Levels law_levels;
    encode_by_law(coder, *law, rest, law_levels);
    Levels others;
    std::set_difference(rest.begin(), rest.end(), law_levels.begin(), law_levels.end(), std::back_inserter(others));
    rest = std::move(others);
  }
  encode_steps(coder, rest);
  return true;
}

/// nullopt: the bytes are damaged; for example, a level would exceed 65 535 or occur twice.
std::optional<Levels> decode_levels(RangeDecoder& coder) {
  Model grain_model = kFlatModel;
  const std::uint32_t grain = decode_number(coder, grain_model);
  if (grain == 0 || grain >= kLevels) return std::nullopt;
  std::optional<Levels> law_levels = Levels{};
  if (coder.decode_bits(1) != 0) law_levels = decode_by_law(coder);
  const std::optional<Levels> rest = law_levels ? decode_steps(coder) : std::nullopt;
  if (!rest) return std::nullopt;
  Levels levels;
  std::merge(rest->begin(), rest->end(), law_levels->begin(), law_levels->end(), std::back_inserter(levels));
  if (std::adjacent_find(levels.begin(), levels.end()) != levels.end()) return std::nullopt;
  if (std::int64_t{levels.back()} * grain >= kLevels) return std::nullopt;
  for (std::uint16_t& level : levels) level = static_cast<std::uint16_t>(level * grain);
  return levels;
}

}  // namespace
}  // namespace telepalp::codec
