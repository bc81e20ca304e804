#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::tissue {

/// The best cut of the end of a series into pieces of straight lines that do not fall, for each place where the end may
/// begin. Dynamic programming; time: pieces × samples^2.
class RisingPieces {
 public:
  /// `step`: distance of the samples. Each piece has `least` samples or more; there are at most `pieces`.
  RisingPieces(std::span<const double> samples, double step, int pieces, std::size_t least);
  /// Sum of squares of the samples from `begin` on about the best pieces; infinite where fewer than `least` are left.
  [[nodiscard]] double squares_from(std::size_t begin) const noexcept { return best_.back()[begin].squares; }
  /// The first sample of each of these pieces.
  [[nodiscard]] std::vector<std::size_t> begins_from(std::size_t begin) const;

 private:
  struct Best {
    double squares;
    std::size_t next;  ///< the first sample of the next piece
  };
  [[nodiscard]] double squares_of(std::size_t begin, std::size_t end) const noexcept;

  double step_;
  std::vector<std::vector<Best>> best_;  ///< for one piece, two pieces, ..., by the first sample
  std::vector<double> y_, yy_, xy_;      ///< sums of all samples before one
};

}  // namespace telepalp::tissue
