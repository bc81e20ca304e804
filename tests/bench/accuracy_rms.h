#pragma once

#include <cmath>

namespace telepalp::bench {

/// Root of the mean of squares, grown one by one; NaN of none.
class RootMeanSquare {
 public:
  void add(double value) {
    sum_ += value * value;
    count_ += 1.0;
  }
  [[nodiscard]] double value() const { return std::sqrt(sum_ / count_); }

 private:
  double sum_ = 0.0;
  double count_ = 0.0;
};

}  // namespace telepalp::bench
