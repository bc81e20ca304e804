#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Ranks (indices into the palette) as run-length tokens. Each pixel is predicted from three neighbours (the median
/// edge detector of LOCO-I; outside the frame counts as not measured). A token states how many consecutive predictions
/// are right, and how the next pixel differs from its prediction: byte = min(run, 31) * 8 + TokenKind. The kind of the
/// previous token selects one of four streams, so that zstd's Huffman coder adapts to that kind. Longer runs and larger
/// steps continue in `extra` as varints. A pixel that is measured where a gap is predicted has its rank in `entries`,
/// as the zigzag-coded difference from the previous entry. An entry does not depend on a neighbouring pixel's rank, so
/// that the reader finds the pixel of each token before it computes ranks, and then computes several rows at once.
struct TokenStreams {
  std::array<std::string, 4> tokens;
  std::string extra;
  std::string entries;
};

enum class TokenKind : std::uint8_t { NotMeasured, Up1, Down1, Up2, Down2, Entry, Up, Down };

inline constexpr std::uint32_t kLongRun = 31;
inline constexpr int kFirstFarStep = 3;  ///< least step [ranks] of the kinds Up and Down

/// Index in `tokens` of the stream that holds the token after one of kind `what`.
[[nodiscard]] constexpr std::size_t stream_after(TokenKind what) noexcept {
  return what < TokenKind::Up2 ? static_cast<std::size_t>(what) : 3;
}

/// The largest number of levels that tokens support: predictions are computed in 16 bits.
inline constexpr std::size_t kMaxTokenLevels = 16384;

/// `samples`, rows of `width`, must all be in `palette`, which has at most kMaxTokenLevels levels.
[[nodiscard]] TokenStreams write_tokens(std::span<const std::uint16_t> samples, int width, const LevelPalette& palette);

/// Fills `samples`, rows of `width`. False when the streams do not describe an image of this size.
[[nodiscard]] bool read_tokens(const TokenStreams& streams, const LevelPalette& palette, int width,
                               std::span<std::uint16_t> samples);

}  // namespace telepalp::codec
