#pragma once

#include <algorithm>

namespace telepalp::impaired {

/// The two-state loss model of Gilbert and Elliott: all packets pass in the good state, none in the bad one. The caller
/// draws the random numbers.
class GilbertElliott {
 public:
  GilbertElliott() = default;
  /// `loss`: share of packets that are lost, 0 to 1. `mean_burst`: mean number of packets lost in a row; if it is below
  /// 1 / (1 - loss), the mean of independent losses, the losses are independent.
  GilbertElliott(double loss, double mean_burst) noexcept { set(loss, mean_burst); }

  /// Changes both parameters; the model stays in its present state.
  void set(double loss, double mean_burst) noexcept {
    const double passed = std::max(1e-9, 1.0 - loss);
    const double burst = std::max(mean_burst, 1.0 / passed);
    ends_ = 1.0 / burst;
    begins_ = loss / (burst * passed);
  }

  /// True if the next packet is lost. `uniform`: a random number in [0, 1).
  [[nodiscard]] bool lost(double uniform) noexcept {
    bad_ = bad_ ? uniform > ends_ : uniform < begins_;
    return bad_;
  }

 private:
  double begins_ = 0.0;  ///< probability that the good state changes to the bad one
  double ends_ = 1.0;    ///< probability that the bad state changes to the good one
  bool bad_ = false;
};

}  // namespace telepalp::impaired
