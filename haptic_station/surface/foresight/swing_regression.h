#pragma once

namespace telepalp::surface {

/// Learns how far the skin goes within one age of the prediction, as a sum of two ways: a share of the way back to its
/// mean place, and a share of the straight prediction. Skin that swings, as while a patient talks, goes on in its
/// direction at first and is beyond its mean place half a swing later, so the shares differ with the age. They are the
/// least-squares fit over the last ten seconds, for the whole body. Owner: surface thread.
class SwingRegression {
 public:
  struct Shares {
    double to_mean = 0.0;
    double straight = 0.0;
  };
  /// The way that a cell went since a prediction, and the two ways that may explain it [m].
  struct Ways {
    double went_m;
    double to_mean_m;
    double straight_m;
  };

  /// Reduces the weight of earlier frames by the age `dt_s`. Call once per frame, before add(), also without an add().
  void pass(double dt_s) noexcept;
  /// Adds a cell of this frame with the weight `counts` [s].
  void add(const Ways& ways, double counts) noexcept;

  [[nodiscard]] Shares shares() const noexcept;

 private:
  // Sums of products of two ways, with a decay over ten seconds [m² s].
  double mean_mean_ = 0.0, mean_straight_ = 0.0, straight_straight_ = 0.0;
  double went_mean_ = 0.0, went_straight_ = 0.0;
};

}  // namespace telepalp::surface
