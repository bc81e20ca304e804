#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace telepalp::codec {

/// Converts prediction errors back into ranks, eight rows in a wavefront: each row is one pixel behind the row above
/// it, and one register holds the current pixel of all eight. Within a row each pixel depends on the pixel before it,
/// so parallelism must come from several rows. A rank is the index of a depth in the frame's palette.
class RankWavefront {
 public:
  static constexpr std::size_t kRows = 8;
  static constexpr std::int16_t kNotMeasured = INT16_MIN / 2;  ///< error that marks a pixel as not measured

  explicit RankWavefront(std::size_t width)
      : width_(width), changes_(places(width)), above_(places(width)), ranks_(places(width)) {}

  /// The prediction error of a pixel, for the caller to set; 0 until then.
  [[nodiscard]] std::int16_t& change(std::size_t row, std::size_t column) noexcept {
    return changes_[place(row, column)];
  }

  /// Computes eight rows of ranks from the errors and the row above them, then resets the errors to 0. Returns the
  /// highest rank, which is arbitrary when the errors are damaged.
  [[nodiscard]] std::uint16_t advance() noexcept;

  [[nodiscard]] std::int16_t rank(std::size_t row, std::size_t column) const noexcept {
    return ranks_[place(row, column)];
  }

 private:
  static std::size_t place(std::size_t row, std::size_t column) noexcept { return (column + row) * kRows + row; }
  static std::size_t places(std::size_t width) noexcept { return (width + 2 * kRows) * kRows; }

  std::size_t width_;
  std::vector<std::int16_t> changes_;
  std::vector<std::int16_t> above_;
  std::vector<std::int16_t> ranks_;
};

}  // namespace telepalp::codec
