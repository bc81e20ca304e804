#pragma once

#include <cmath>

namespace telepalp::bench {

/// Root mean square of values that are added one at a time; NaN without values.
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
