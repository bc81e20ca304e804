#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Ranks as tokens. Each pixel is predicted from the three before it (the median edge detector of LOCO-I, out of frame
/// = not measured). A token says how many predictions in a row came right, and what the pixel after them is:
/// byte = min(run, 31) * 8 + TokenKind. Tokens lie in four streams, chosen by the kind before: what zstd's Huffman
/// stage cannot see of the context, the stream says. Longer runs and larger steps go on in `extra`, as varints. A pixel
/// measured where the prediction says that none is has its rank in `entries`, as the step from the entry before, in
/// zigzag. Why not as a step from a neighbour: whoever lays tokens out then knows what they change without knowing any
/// rank, so that many rows are predicted at once.
struct TokenStreams {
  std::array<std::string, 4> tokens;
  std::string extra;
  std::string entries;
};

enum class TokenKind : std::uint8_t { NotMeasured, Up1, Down1, Up2, Down2, Entry, Up, Down };

inline constexpr std::uint32_t kLongRun = 31;
inline constexpr int kFirstFarStep = 3;  ///< Up and Down begin here

/// The stream that holds the token after one of this kind.
[[nodiscard]] constexpr std::size_t stream_after(TokenKind what) noexcept {
  return what < TokenKind::Up2 ? static_cast<std::size_t>(what) : 3;
}

/// Most levels that tokens may have: the prediction is made in 16 bits.
inline constexpr std::size_t kMaxTokenLevels = 16384;

/// `samples` must all be in `palette`.
[[nodiscard]] TokenStreams write_tokens(std::span<const std::uint16_t> samples, int width, const LevelPalette& palette);

/// Fills `samples`, rows of `width`. False when the streams do not describe such an image.
[[nodiscard]] bool read_tokens(const TokenStreams& streams, const LevelPalette& palette, int width,
                               std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
