#pragma once

#include <vector>

#include "haptic_station/surface/snapshot/surface_snapshot.h"
#include "haptic_station/surface/temporal/breathing_model.h"
#include "haptic_station/surface/temporal/cell_lattice.h"

namespace telepalp::surface {

/// What one cell of the image saw in a frame: the mean of measured minus predicted depth over `count` pixels.
struct CellInnovation {
  double mean_m = 0.0;
  double count = 0.0;
  double sigma_m = 0.0;  ///< of the mean, by chance
};

/// How the scene moves along the rays of sight, cell by cell: each cell's displacement and velocity by a g-h filter,
/// and the breath that they share. Cells average some hundred pixels, so that motion is known far below the pixels'
/// noise; the pixels' detail is averaged on top of it. Between cells everything is a cubic spline, and what is kept for
/// each cell are its coefficients.
class MotionField {
 public:
  MotionField(int width_px, int height_px, bool breathing);

  [[nodiscard]] const CellLattice& lattice() const noexcept { return lattice_; }

  /// Moves on to the next frame, `dt_s` later. Call once for each frame, before correct().
  void predict(double dt_s);
  /// Takes in what was seen: measured minus change().
  void correct(const std::vector<CellInnovation>& seen, double dt_s);

  /// Expected change of depth since the frame before, as coefficients.
  [[nodiscard]] const std::vector<float>& change() const noexcept { return change_; }
  /// The same, corrected by what was seen.
  [[nodiscard]] const std::vector<float>& moved() const noexcept { return moved_; }
  /// The change and all that was seen beside it, chance included.
  [[nodiscard]] const std::vector<float>& expected() const noexcept { return expected_; }

  /// Terms of the motion of depth after the last frame, as coefficients.
  [[nodiscard]] const std::vector<MotionTerms>& terms() const noexcept { return terms_; }
  [[nodiscard]] MotionModel model() const noexcept;

 private:
  struct Cell {
    double velocity_m_per_s = 0.0;
    double energy = 0.0;  ///< slow mean of the squared velocity: what moves leads the breathing model
    double frames = 0.0;
    double lean_m = 0.0;  ///< running mean of the neighbourhood's innovation: what the filter fails to follow
  };

  void update_moving(const std::vector<CellInnovation>& seen);
  void correct_cell(std::size_t at, double innovation_m, double dt_s) noexcept;
  void smooth_velocities();
  void update_observed();
  [[nodiscard]] double believed() const noexcept { return breathing_wanted_ ? breathing_.confidence() : 0.0; }
  void update_terms();

  CellLattice lattice_;
  bool breathing_wanted_;
  std::vector<Cell> cells_;
  std::vector<CellMean> means_;
  std::vector<CellMean> moving_;     ///< how clearly each cell's neighbourhood leans, 0 to 1
  std::vector<float> displacement_;  ///< of each cell since the start [m]
  std::vector<float> observed_;  ///< the same, but as measured: what the breath is fitted to must not be its own echo
  std::vector<float> weight_;
  std::vector<float> change_;
  std::vector<float> moved_;
  std::vector<float> expected_;
  std::vector<MotionTerms> terms_;
  BreathingModel breathing_;
  double miss_m_ = 0.0;  ///< running mean of |innovation| of what moves
  double frame_s_ = 0.033;
};

}  // namespace telepalp::surface
