#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptic_station/surface/foresight/past_predictions.h"
#include "haptic_station/surface/foresight/recent_mean.h"
#include "haptic_station/surface/foresight/recent_way.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/temporal/breathing_model.h"
#include "haptic_station/surface/temporal/cell_gains.h"
#include "haptic_station/surface/temporal/cell_lattice.h"
#include "haptic_station/surface/temporal/shared_motion.h"
#include "haptic_station/surface/temporal/straight_motion.h"

namespace telepalp::surface {

/// The motion of the scene as a change of depth, by cell: a g-h filter (position and velocity) estimates each cell's
/// motion relative to SharedMotion, and all cells share one breathing model. A cell averages up to 256 pixels, so its
/// motion is known far more accurately than a pixel's depth. TemporalFilter moves the average depth of each pixel by
/// this field. A cubic spline interpolates between cells; this class stores the coefficients of the spline.
class MotionField {
 public:
  MotionField(int width_px, int height_px, const SurfaceSettings& settings);

  [[nodiscard]] const CellLattice& lattice() const noexcept { return lattice_; }

  /// Predicts the motion from the last frame to the next one, `dt_s` later. Call once for each frame, before correct().
  void predict(double dt_s);
  /// Updates the filters with the cells' innovations in a frame: measured depth minus the depth that change() predicts.
  /// `hidden`: 1 for each cell that an object hides; these cells follow the others (fill_hidden()). Empty: none.
  void correct(const std::vector<CellInnovation>& seen, double dt_s, std::span<const std::uint8_t> hidden = {});

  /// The change of depth since the last frame as predict() expects it, as spline coefficients [m].
  [[nodiscard]] const std::vector<float>& change() const noexcept { return change_; }
  /// The change of depth since the last frame as correct() estimates it, as spline coefficients [m].
  [[nodiscard]] const std::vector<float>& moved() const noexcept { return moved_; }
  /// change() plus the whole innovation, noise included, as spline coefficients [m].
  [[nodiscard]] const std::vector<float>& expected() const noexcept { return expected_; }

  /// Predicted change of depth after the last frame: for each cell, the spline coefficient of each of MotionTerms.
  [[nodiscard]] const std::vector<MotionTerms>& terms() const noexcept { return terms_; }
  [[nodiscard]] MotionModel model() const noexcept;

 private:
  void update_gains(const std::vector<CellInnovation>& seen);
  void correct_shared(const std::vector<CellInnovation>& seen, const std::vector<float>& innovation, double dt_s);
  void correct_cell(std::size_t at, double innovation_m, double dt_s) noexcept;
  void update_observed();
  void take_means(const std::vector<CellInnovation>& seen);
  [[nodiscard]] std::vector<CellInnovation> filled(const std::vector<CellInnovation>& seen,
                                                   std::span<const std::uint8_t> hidden) const;
  void judge_predictions(const std::vector<CellInnovation>& seen, double dt_s);
  [[nodiscard]] double believed() const noexcept { return breathing_wanted_ ? breathing_.confidence() : 0.0; }
  void update_terms();
  [[nodiscard]] MotionModel unbounded_model() const noexcept;
  [[nodiscard]] MotionModel model_of_each() const noexcept;
  [[nodiscard]] double fastest_m_per_s() const noexcept;
  [[nodiscard]] double rate_rad_per_s() const noexcept;

  CellLattice lattice_;
  bool breathing_wanted_;
  bool shared_wanted_;
  std::vector<double> velocity_m_per_s_;  ///< of each cell, minus its share of SharedMotion's velocity
  std::vector<double> energy_;  ///< running mean of each cell's squared speed, shared part included; gives weight_
  std::vector<CellMean> means_;
  CellGains gains_;
  std::vector<float> displacement_;  ///< estimated displacement of each cell since the first frame [m]
  std::vector<float> observed_;      ///< measured displacement of each cell; the breathing model is fitted to it
  std::vector<float> weight_;        ///< of each cell in the fit of the breathing rate
  std::vector<float> change_;
  std::vector<float> moved_;
  std::vector<float> expected_;
  std::vector<MotionTerms> terms_;
  BreathingModel breathing_;
  SharedMotion shared_;
  std::vector<SharedInnovation> shared_seen_;
  StraightMotion straight_;
  PastPredictions past_;
  RecentWay way_;
  RecentMean mean_;
  std::vector<float> counts_;  ///< 1 for a cell that the last frame measured, otherwise 0
  double miss_m_ = 0.0;        ///< running mean of |innovation|, weighted by `weight_`
  double frame_s_ = 0.033;
};

}  // namespace telepalp::surface
