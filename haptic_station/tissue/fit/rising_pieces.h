#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace telepalp::tissue {

/// For each sample of a series: the best cut of the samples from this one to the end into straight lines that do not
/// fall. Best means the least sum of squares of the samples about their lines. Dynamic programming; time: pieces ×
/// samples^2.
class RisingPieces {
 public:
  /// `step`: distance between two samples. A cut has at most `pieces` lines, each of at least `least` samples.
  RisingPieces(std::span<const double> samples, double step, int pieces, std::size_t least);
  /// Sum of squares of the best cut from sample `begin` on; infinite if fewer than `least` samples are left.
  [[nodiscard]] double squares_from(std::size_t begin) const noexcept { return best_.back()[begin].squares; }
  /// The first sample of each line of the best cut from sample `begin` on.
  [[nodiscard]] std::vector<std::size_t> begins_from(std::size_t begin) const;

 private:
  struct Best {
    double squares;
    std::size_t next;  ///< the first sample of the next piece
  };
  [[nodiscard]] double squares_of(std::size_t begin, std::size_t end) const noexcept;

  double step_;
  std::vector<std::vector<Best>> best_;  ///< [k][i]: of the best cut from sample i on into at most k + 1 lines
  std::vector<double> y_, yy_, xy_;      ///< [i]: sums over all samples before sample i
};

}  // namespace telepalp::tissue
