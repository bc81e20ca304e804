#pragma once

#include <span>
#include <vector>

#include "haptic_station/surface/temporal/cell_gains.h"

namespace telepalp::surface {

/// The straight prediction: each cell continues at its own velocity, whatever the rest of the body does. A g-h filter
/// for each cell estimates this velocity. MotionField's filters cannot serve: they estimate a cell's velocity minus the
/// part that SharedMotion predicts for the cell, and SharedMotion errs while the body does not move as one. Owner:
/// surface thread.
class StraightMotion {
 public:
  explicit StraightMotion(const CellLattice& lattice);

  /// Advances each cell by its velocity. Call once for each frame, before correct().
  void predict(double dt_s) noexcept;
  /// Updates the filters with a frame. `seen` holds innovations relative to `modelled_m`, the change of each cell's
  /// depth since the first frame that MotionField had predicted, as spline coefficients.
  void correct(std::span<const CellInnovation> seen, std::span<const float> modelled_m, double dt_s);
  /// Takes the smoothed change of each cell's depth since the first frame [m], measured in the frame given to
  /// correct().
  void measure(std::span<const float> measured_m, double dt_s);

  /// The velocity of the cell's filter, limited to kMeasuredShare of the speed between the last two frames in the
  /// direction of this velocity, plus kMeasuredMargin_m_per_s. So the prediction ends one frame after the motion,
  /// although the filter's velocity takes several frames to fall to 0.
  [[nodiscard]] double velocity_m_per_s(std::size_t cell) const noexcept;

  static constexpr double kMeasuredShare = 0.8;
  static constexpr double kMeasuredMargin_m_per_s = 0.005;  ///< above the noise of the measured speed, 2 mm/s at 30 Hz

 private:
  CellLattice lattice_;
  CellGains gains_;
  std::vector<double> velocity_m_per_s_;
  std::vector<float> displacement_m_;  ///< since the first frame, as spline coefficients
  std::vector<float> measured_m_;      ///< displacement that the last frame measured
  std::vector<float> measured_m_per_s_;
};

}  // namespace telepalp::surface
