#include "codec/fast_tokens.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "proto/words/vectorised.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace telepalp::codec {
namespace {

using Rank = std::int16_t;

enum Exception : unsigned { NotMeasured, Up1, Down1, Up2, Down2, AsBefore, Up, Down };
constexpr unsigned kLongRun = 31;
constexpr Rank kFirstStep = 3;  // Up and Down begin here where the prediction was measured

/// The stream that holds the token after one with this exception.
constexpr std::size_t stream_after(Exception what) noexcept { return std::min<std::size_t>(what, 3); }

Rank predict(Rank west, Rank north, Rank north_west) noexcept {
  const Rank low = std::min(west, north);
  const Rank high = std::max(west, north);
  return std::max(low, std::min(high, static_cast<Rank>(west + north - north_west)));
}

/// A row of ranks with one place of "not measured" in front, and room behind to write eight at once.
class PaddedRow {
 public:
  explicit PaddedRow(std::size_t width) : ranks_(width + 1 + 8) {}
  [[nodiscard]] Rank* data() noexcept { return ranks_.data() + 1; }
  void swap(PaddedRow& other) noexcept { ranks_.swap(other.ranks_); }

 private:
  std::vector<Rank> ranks_;
};

/// Collects tokens; remembers what is carried from one to the next.
class TokenWriter {
 public:
  explicit TokenWriter(std::size_t pixels) {
    for (std::string& stream : streams_.tokens) stream.resize(pixels);
  }

  /// `rank` lies `run` right predictions after the exception before, and was predicted wrongly.
  void exception(std::uint32_t run, Rank rank, Rank predicted) {
    const int base = predicted != 0 ? predicted : last_measured_;
    const int step = rank - base;
    const int place = std::clamp(step, -3, 3) + 3;
    const Exception what = rank == 0 ? NotMeasured : kOfStep[static_cast<std::size_t>(place)];
    streams_.tokens[stream_][used_[stream_]++] = static_cast<char>(std::min(run, kLongRun) * 8 + what);
    if (run >= kLongRun) append_varint(streams_.extra, run - kLongRun);
    if (what >= Up) append_varint(streams_.extra, static_cast<std::uint32_t>(std::abs(step) - kFirstStep));
    last_measured_ = rank != 0 ? rank : last_measured_;
    stream_ = stream_after(what);
  }

  [[nodiscard]] TokenStreams finish() && {
    for (std::size_t i = 0; i < used_.size(); ++i) streams_.tokens[i].resize(used_[i]);
    return std::move(streams_);
  }

 private:
  static constexpr std::array<Exception, 7> kOfStep{Down, Down2, Down1, AsBefore, Up1, Up2, Up};

  TokenStreams streams_;
  std::array<std::size_t, 4> used_{};
  std::size_t stream_ = 0;
  Rank last_measured_ = 1;
};

/// Where predictions fail, pixel by pixel, and by how much where that takes more than a token.
struct Exceptions {
  std::vector<std::uint8_t> at;  ///< 0: as predicted; else 1 + Exception
  std::vector<Rank> far_steps;   ///< of Up and Down, in order
};

/// Lays the tokens out over the image. nullopt when they run out of it, or are left over.
std::optional<Exceptions> lay_out(const TokenStreams& streams, std::size_t pixels) {
  Exceptions exceptions{.at = std::vector<std::uint8_t>(pixels), .far_steps = {}};
  ByteReader extra(std::as_bytes(std::span(streams.extra)));
  std::array<const char*, 4> next{};
  std::array<const char*, 4> end{};
  for (std::size_t i = 0; i < next.size(); ++i) {
    next[i] = streams.tokens[i].data();
    end[i] = next[i] + streams.tokens[i].size();
  }
  std::size_t pixel = 0;
  std::size_t stream = 0;
  while (next[stream] != end[stream]) {
    const auto token = static_cast<std::uint8_t>(*next[stream]++);
    const auto what = static_cast<Exception>(token % 8);
    stream = stream_after(what);
    pixel += token / 8;
    if (token / 8 == kLongRun) [[unlikely]] {
      const std::optional<std::uint32_t> more = extra.varint();
      if (!more) return std::nullopt;
      pixel += *more;
    }
    if (pixel >= pixels) return std::nullopt;
    exceptions.at[pixel++] = static_cast<std::uint8_t>(1 + what);
    if (what >= Up) [[unlikely]] {
      const std::optional<std::uint32_t> more = extra.varint();
      if (!more || *more > kMaxTokenLevels) return std::nullopt;
      const int step = kFirstStep + static_cast<int>(*more);
      exceptions.far_steps.push_back(static_cast<Rank>(what == Up ? step : -step));
    }
  }
  if (next != end) return std::nullopt;
  if (!extra.empty()) return std::nullopt;
  return exceptions;
}

#if defined(__SSE2__)
/// One rank, in the lowest place of a vector register. Why: the least and the greater of two are one instruction each
/// there, and each pixel waits for the one before it.
struct Lane {
  __m128i v = _mm_setzero_si128();

  Lane() = default;
  explicit Lane(__m128i register_) noexcept : v(register_) {}
  explicit Lane(int rank) noexcept : v(_mm_cvtsi32_si128(rank)) {}
  static Lane at(const Rank* rank) noexcept {
    std::int32_t two_ranks = 0;  // one more is read than asked for, as rows have room behind
    std::memcpy(&two_ranks, rank, sizeof two_ranks);
    return Lane(_mm_cvtsi32_si128(two_ranks));
  }
  [[nodiscard]] Rank rank() const noexcept { return static_cast<Rank>(_mm_cvtsi128_si32(v)); }
  friend Lane operator+(Lane a, Lane b) noexcept { return Lane(_mm_add_epi16(a.v, b.v)); }
  friend Lane operator-(Lane a, Lane b) noexcept { return Lane(_mm_sub_epi16(a.v, b.v)); }
  friend Lane operator&(Lane a, Lane b) noexcept { return Lane(_mm_and_si128(a.v, b.v)); }
  friend Lane least(Lane a, Lane b) noexcept { return Lane(_mm_min_epi16(a.v, b.v)); }
  friend Lane greatest(Lane a, Lane b) noexcept { return Lane(_mm_max_epi16(a.v, b.v)); }
};
#else
/// One rank.
struct Lane {
  Rank v = 0;

  Lane() = default;
  explicit Lane(int rank) noexcept : v(static_cast<Rank>(rank)) {}
  static Lane at(const Rank* rank) noexcept { return Lane(*rank); }
  [[nodiscard]] Rank rank() const noexcept { return v; }
  friend Lane operator+(Lane a, Lane b) noexcept { return Lane(a.v + b.v); }
  friend Lane operator-(Lane a, Lane b) noexcept { return Lane(a.v - b.v); }
  friend Lane operator&(Lane a, Lane b) noexcept { return Lane(a.v & b.v); }
  friend Lane least(Lane a, Lane b) noexcept { return a.v < b.v ? a : b; }
  friend Lane greatest(Lane a, Lane b) noexcept { return a.v < b.v ? b : a; }
};
#endif

Lane predict(Lane west, Lane north, Lane north_minus_north_west) noexcept {
  return greatest(least(west, north), least(greatest(west, north), west + north_minus_north_west));
}

struct Change {
  std::int32_t step;
  std::int32_t mask;
};

/// What each entry of Exceptions::at does to a prediction, but for those that the slow path sees to.
constexpr std::array<Change, 9> kChanges{{{0, -1}, {0, 0}, {1, -1}, {-1, -1}, {2, -1}, {-2, -1}, {}, {}, {}}};
constexpr std::uint8_t kFirstSlow = 1 + AsBefore;

/// Turns predictions and exceptions back into ranks, row by row.
class RankReader {
 public:
  explicit RankReader(const Exceptions& exceptions) : exceptions_(exceptions) {}

  /// `row` and `above` have a rank in front and room for eight behind. False when steps run out.
  [[nodiscard]] bool row(Rank* row, const Rank* above, std::size_t first_pixel, std::size_t width) noexcept {
    const std::uint8_t* const at = exceptions_.at.data() + first_pixel;
    Lane west;
    Lane north_west;
    std::size_t x = 0;
    for (; x + 8 <= width; x += 8) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, at + x, 8);
      if (eight == 0) {
        for (std::size_t i = 0; i < 8; ++i) step_over(row + x + i, above + x + i, west, north_west);
      } else {
        for (std::size_t i = 0; i < 8; ++i) step_over(row + x + i, above + x + i, west, north_west, at[x + i]);
      }
    }
    for (std::size_t left = width % 8; left != 0; --left, ++x) step_over(row + x, above + x, west, north_west, at[x]);
    return !overrun_;
  }

 private:
  void step_over(Rank* here, const Rank* above, Lane& west, Lane& north_west) const noexcept {
    const Lane north = Lane::at(above);
    west = predict(west, north, north - north_west);
    north_west = north;
    *here = west.rank();
  }

  void step_over(Rank* here, const Rank* above, Lane& west, Lane& north_west, std::uint8_t exception) noexcept {
    step_over(here, above, west, north_west);
    west = changed(west, exception);
    *here = west.rank();
  }

  [[nodiscard]] Lane changed(Lane predicted, std::uint8_t exception) noexcept {
    if (exception >= kFirstSlow || (exception != 0 && predicted.rank() == 0)) [[unlikely]]
      return slowly(predicted.rank(), exception);
    const Lane rank = (predicted + Lane(kChanges[exception].step)) & Lane(kChanges[exception].mask);
    last_measured_ = exception > 1 + NotMeasured ? rank.rank() : last_measured_;
    return rank;
  }

  [[nodiscard]] Lane slowly(Rank predicted, std::uint8_t exception) noexcept {
    if (exception == 1 + NotMeasured) return Lane();
    const int base = predicted != 0 ? predicted : last_measured_;
    last_measured_ = static_cast<Rank>(base + step(exception));
    return Lane(last_measured_);
  }

  [[nodiscard]] int step(std::uint8_t exception) noexcept {
    if (exception <= kFirstSlow) return exception == kFirstSlow ? 0 : kChanges[exception].step;
    if (far_ == exceptions_.far_steps.size()) overrun_ = true;
    return overrun_ ? 0 : exceptions_.far_steps[far_++];
  }

  const Exceptions& exceptions_;
  std::size_t far_ = 0;
  Rank last_measured_ = 1;
  bool overrun_ = false;
};

/// Predicts a whole row at once, and packs where that fails into `wrong`, a bit a pixel.
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

/// The top bits of eight bytes, the first lowest.
std::uint64_t top_bits(const std::uint8_t* eight_bytes) noexcept {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, eight_bytes, 8);
  return (((bytes >> 7) * 0x0102040810204080) >> 56) & 0xff;
}

/// One bit for each of the 64 pixels from `is_wrong` on.
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
  std::vector<std::uint8_t> is_wrong(columns + kBlock);  // beyond the row: never wrong
  TokenWriter writer(samples.size());
  std::size_t next = 0;  // the pixel after the last exception
  for (std::size_t first = 0; first < samples.size(); first += columns) {
    for (std::size_t x = 0; x < columns; ++x) row.data()[x] = static_cast<Rank>(rank_of[samples[first + x]]);
    predict_row(row.data(), above.data(), predicted.data(), is_wrong.data(), columns);
    for (std::size_t block = 0; block < columns; block += kBlock)
      for (std::uint64_t wrong = wrong_bits(is_wrong.data() + block); wrong != 0; wrong &= wrong - 1) {
        const std::size_t x = block + static_cast<std::size_t>(std::countr_zero(wrong));
        writer.exception(static_cast<std::uint32_t>(first + x - next), row.data()[x], predicted[x]);
        next = first + x + 1;
      }
    row.swap(above);
  }
  return std::move(writer).finish();
}

bool read_tokens(const TokenStreams& streams, const LevelPalette& palette, int width,
                 std::span<std::uint16_t> samples) {
  const std::optional<Exceptions> exceptions = lay_out(streams, samples.size());
  if (!exceptions) return false;
  const auto columns = static_cast<std::size_t>(width);
  PaddedRow row(columns);
  PaddedRow above(columns);
  RankReader reader(*exceptions);
  for (std::size_t first = 0; first < samples.size(); first += columns) {
    if (!reader.row(row.data(), above.data(), first, columns)) return false;
    std::uint16_t highest = 0;  // a rank below 0 is a high one
    for (std::size_t x = 0; x < columns; ++x) highest = std::max(highest, static_cast<std::uint16_t>(row.data()[x]));
    if (highest >= palette.size()) return false;
    for (std::size_t x = 0; x < columns; ++x)
      samples[first + x] = palette.levels[static_cast<std::size_t>(row.data()[x])];
    row.swap(above);
  }
  return true;
}

}  // namespace telepalp::codec
