#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace telepalp::codec {

/// Turns changes back into ranks, eight rows at once: each row is a step behind the one above, whose ranks it predicts
/// from, and all eight take each step together, in one register. Why: within a row every pixel waits for the one
/// before.
class RankWavefront {
 public:
  static constexpr std::size_t kRows = 8;
  static constexpr std::int16_t kNotMeasured = INT16_MIN / 2;  ///< the change of a pixel that was not measured

  explicit RankWavefront(std::size_t width)
      : width_(width), changes_(places(width)), above_(places(width)), ranks_(places(width)) {}

  /// Where the change of a pixel goes, to be added to its prediction: 0 but for those put there.
  [[nodiscard]] std::int16_t& change(std::size_t row, std::size_t column) noexcept {
    return changes_[place(row, column)];
  }

  /// Makes ranks of the changes, which are then 0 again, and of the eight rows before. The highest rank of all; where
  /// changes are damaged it may be anything.
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
