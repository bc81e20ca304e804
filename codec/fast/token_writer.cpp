#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "codec/fast/tokens.h"
#include "proto/words/vectorised.h"

namespace telepalp::codec {
namespace {

using Rank = std::int16_t;

Rank predict(Rank west, Rank north, Rank north_west) noexcept {
  const Rank low = std::min(west, north);
  const Rank high = std::max(west, north);
  return std::max(low, std::min(high, static_cast<Rank>(west + north - north_west)));
}

/// A row of ranks with one "not measured" in front.
class PaddedRow {
 public:
  explicit PaddedRow(std::size_t width) : ranks_(width + 1) {}
  [[nodiscard]] Rank* data() noexcept { return ranks_.data() + 1; }
  void swap(PaddedRow& other) noexcept { ranks_.swap(other.ranks_); }

 private:
  std::vector<Rank> ranks_;
};

/// Collects tokens, with the state that passes from one token to the next.
class TokenWriter {
 public:
  explicit TokenWriter(std::size_t pixels) {
    for (std::string& stream : streams_.tokens) stream.resize(pixels);
  }

  /// Adds a token: after `run` right predictions, `rank` was predicted wrongly as `predicted`.
  void token(std::uint32_t run, Rank rank, Rank predicted) {
    const int step = rank - predicted;
    const TokenKind what = kind(rank, predicted);
    streams_.tokens[stream_][used_[stream_]++] =
        static_cast<char>(std::min(run, kLongRun) * 8 + static_cast<unsigned>(what));
    if (run >= kLongRun) append_varint(streams_.extra, run - kLongRun);
    if (what == TokenKind::Entry) entry(rank);
    if (what > TokenKind::Entry)
      append_varint(streams_.extra, static_cast<std::uint32_t>(std::abs(step) - kFirstFarStep));
    stream_ = stream_after(what);
  }

  [[nodiscard]] TokenStreams finish() && {
    for (std::size_t i = 0; i < used_.size(); ++i) streams_.tokens[i].resize(used_[i]);
    return std::move(streams_);
  }

 private:
  static TokenKind kind(Rank rank, Rank predicted) noexcept {
    constexpr std::array<TokenKind, 7> kOfStep{TokenKind::Down, TokenKind::Down2, TokenKind::Down1, TokenKind::Entry,
                                               TokenKind::Up1,  TokenKind::Up2,   TokenKind::Up};
    if (rank == 0) return TokenKind::NotMeasured;
    if (predicted == 0) return TokenKind::Entry;
    return kOfStep[static_cast<std::size_t>(std::clamp(rank - predicted, -kFirstFarStep, kFirstFarStep) + 3)];
  }

  void entry(Rank rank) {
    const int step = rank - std::exchange(entry_before_, rank);
    append_varint(streams_.entries, static_cast<std::uint32_t>(step < 0 ? -2 * step - 1 : 2 * step));
  }

  TokenStreams streams_;
  std::array<std::size_t, 4> used_{};
  std::size_t stream_ = 0;
  Rank entry_before_ = 1;
};

/// Predicts a whole row at once and sets `wrong`, one bit per pixel, where the prediction is wrong.
TELEPALP_VECTORISED void predict_row(const Rank* row, const Rank* above, Rank* predicted, std::uint8_t* is_wrong,
                                     std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const Rank west = row[static_cast<std::ptrdiff_t>(x) - 1];
    const Rank north = above[x];
    const Rank north_west = above[static_cast<std::ptrdiff_t>(x) - 1];
    predicted[x] = predict(west, north, north_west);
    is_wrong[x] = predicted[x] == row[x] ? 0 : 0x80;
  }
}

/// The top bits of eight bytes; the bit of the first byte is the lowest.
std::uint64_t top_bits(const std::uint8_t* eight_bytes) noexcept {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, eight_bytes, 8);
  return (((bytes >> 7) * 0x0102040810204080) >> 56) & 0xff;
}

/// Packs 64 bytes from `is_wrong` on into one bit for each pixel.
std::uint64_t wrong_bits(const std::uint8_t* is_wrong) noexcept {
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < 8; ++i) bits |= top_bits(is_wrong + std::size_t{8} * i) << (8 * i);
  return bits;
}

}  // namespace

TokenStreams write_tokens(std::span<const std::uint16_t> samples, int width, const LevelPalette& palette) {
  constexpr std::size_t kBlock = 64;
  const RankOfLevel rank_of = ranks_of(palette);
  const auto columns = static_cast<std::size_t>(width);
  PaddedRow row(columns);
  PaddedRow above(columns);
  std::vector<Rank> predicted(columns);
  std::vector<std::uint8_t> is_wrong(columns + kBlock);  // bytes beyond the row stay 0, "not wrong"
  TokenWriter writer(samples.size());
  std::size_t next = 0;  // the pixel after the last token's pixel
  for (std::size_t first = 0; first < samples.size(); first += columns) {
    for (std::size_t x = 0; x < columns; ++x) row.data()[x] = static_cast<Rank>(rank_of[samples[first + x]]);
    predict_row(row.data(), above.data(), predicted.data(), is_wrong.data(), columns);
    for (std::size_t block = 0; block < columns; block += kBlock)
      for (std::uint64_t wrong = wrong_bits(is_wrong.data() + block); wrong != 0; wrong &= wrong - 1) {
        const std::size_t x = block + static_cast<std::size_t>(std::countr_zero(wrong));
        writer.token(static_cast<std::uint32_t>(first + x - next), row.data()[x], predicted[x]);
        next = first + x + 1;
      }
    row.swap(above);
  }
  return std::move(writer).finish();
}

}  // namespace telepalp::codec
