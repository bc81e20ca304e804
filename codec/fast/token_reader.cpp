#include <algorithm>
#include <array>

#include "codec/fast/rank_wavefront.h"
#include "codec/fast/tokens.h"

namespace telepalp::codec {
namespace {

/// The prediction error that each kind of token states; kinds with a number in another stream are left out.
constexpr std::array<std::int16_t, 5> kChanges{RankWavefront::kNotMeasured, 1, -1, 2, -2};

/// Reads tokens in order.
class TokenReader {
 public:
  TokenReader(const TokenStreams& streams, std::size_t pixels)
      : pixels_(pixels),
        extra_(std::as_bytes(std::span(streams.extra))),
        entries_(std::as_bytes(std::span(streams.entries))) {
    for (std::size_t i = 0; i < next_.size(); ++i) {
      next_[i] = streams.tokens[i].data();
      end_[i] = next_[i] + streams.tokens[i].size();
    }
  }

  /// Writes the prediction errors of eight rows, from pixel `first` on, into `rows`. False when tokens are damaged.
  [[nodiscard]] bool lay_out(std::size_t first, std::size_t width, RankWavefront& rows) noexcept {
    const std::size_t end = std::min(pixels_, first + RankWavefront::kRows * width);
    std::size_t row = 0;
    std::size_t row_end = first + width;
    while (waits_ || next()) {
      waits_ = pixel_ >= end;
      if (waits_) return true;
      for (; pixel_ >= row_end; row_end += width) ++row;
      rows.change(row, pixel_ + width - row_end) = change_;
      ++pixel_;
    }
    return !damaged_;
  }

  /// True when all streams were read exactly to their ends.
  [[nodiscard]] bool done() const noexcept { return !damaged_ && next_ == end_ && extra_.empty() && entries_.empty(); }

 private:
  /// Reads the next token and sets `pixel_` and `change_`. False at the end, or when tokens are damaged.
  [[nodiscard]] bool next() noexcept {
    if (next_[stream_] == end_[stream_]) return false;
    const auto token = static_cast<std::uint8_t>(*next_[stream_]++);
    const auto what = static_cast<TokenKind>(token % 8);
    stream_ = stream_after(what);
    pixel_ += token / 8;
    if (token / 8 == kLongRun) [[unlikely]]
      pixel_ += number(extra_, pixels_);
    if (what < TokenKind::Entry) [[likely]]
      change_ = kChanges[static_cast<std::size_t>(what)];
    else
      change_ = what == TokenKind::Entry ? entry() : far(what);
    damaged_ |= pixel_ >= pixels_;
    return !damaged_;
  }

  [[nodiscard]] std::int16_t entry() noexcept {
    const std::uint32_t zigzag = number(entries_, 2 * kMaxTokenLevels);
    const auto size = static_cast<int>((zigzag + 1) / 2);
    entry_before_ += zigzag % 2 == 0 ? size : -size;
    damaged_ |= entry_before_ <= 0 || entry_before_ >= static_cast<int>(kMaxTokenLevels);
    return static_cast<std::int16_t>(entry_before_);
  }

  [[nodiscard]] std::int16_t far(TokenKind what) noexcept {
    const int step = kFirstFarStep + static_cast<int>(number(extra_, kMaxTokenLevels));
    return static_cast<std::int16_t>(what == TokenKind::Up ? step : -step);
  }

  [[nodiscard]] std::uint32_t number(ByteReader& from, std::size_t most) noexcept {
    const std::optional<std::uint32_t> number = from.varint();
    damaged_ |= !number || *number > most;
    return damaged_ ? 0 : *number;
  }

  std::size_t pixels_;
  ByteReader extra_;
  ByteReader entries_;
  std::array<const char*, 4> next_{};
  std::array<const char*, 4> end_{};
  std::size_t stream_ = 0;
  std::size_t pixel_ = 0;
  std::int16_t change_ = 0;
  int entry_before_ = 1;
  bool waits_ = false;  // a token was read whose pixel lies beyond the eight rows
  bool damaged_ = false;
};

}  // namespace

bool read_tokens(const TokenStreams& streams, const LevelPalette& palette, int width,
                 std::span<std::uint16_t> samples) {
  const auto columns = static_cast<std::size_t>(width);
  TokenReader tokens(streams, samples.size());
  RankWavefront rows(columns);
  std::size_t row = 0;
  for (std::size_t first = 0; first < samples.size(); first += columns, ++row) {
    if (row % RankWavefront::kRows == 0) {
      if (!tokens.lay_out(first, columns, rows)) return false;
      if (rows.advance() >= palette.size()) return false;
    }
    for (std::size_t x = 0; x < columns; ++x)
      samples[first + x] = palette.levels[static_cast<std::size_t>(rows.rank(row % RankWavefront::kRows, x))];
  }
  return tokens.done();
}

}  // namespace telepalp::codec
