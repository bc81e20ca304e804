#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "codec/level_palette.h"

namespace telepalp::codec {

/// Ranks as tokens. Each pixel is predicted from the three before it (the median edge detector of LOCO-I, out of frame
/// = not measured). A token says how many predictions in a row came right, and what the pixel after them is:
/// byte = min(run, 31) * 8 + exception. Tokens lie in four streams, chosen by the exception before: what zstd's Huffman
/// stage cannot see of the context, the stream says. Longer runs and larger steps go on in `extra`, as varints.
struct TokenStreams {
  std::array<std::string, 4> tokens;
  std::string extra;
};

/// Most levels that tokens may have: the prediction is made in 16 bits.
inline constexpr std::size_t kMaxTokenLevels = 16384;

/// `samples` must all be in `palette`.
[[nodiscard]] TokenStreams write_tokens(std::span<const std::uint16_t> samples, int width, const LevelPalette& palette);

/// Fills `samples`, rows of `width`. False when the streams do not describe such an image.
[[nodiscard]] bool read_tokens(const TokenStreams& streams, const LevelPalette& palette, int width,
                               std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
