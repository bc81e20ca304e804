#pragma once

#include <vector>

#include "haptic_station/surface/breathing_model.h"
#include "haptic_station/surface/surface_snapshot.h"

namespace telepalp::surface {

/// What one cell of the image saw in a frame: the mean of measured minus predicted depth over `count` pixels.
struct CellInnovation {
  double mean_m = 0.0;
  double count = 0.0;
  double sigma_m = 0.0;  ///< of the mean, by chance
};

/// How the scene moves along the rays of sight, cell by cell of kCell_px pixels: each cell's displacement and velocity
/// by a g–h filter, and the breath that they share. Cells average some hundred pixels, so that motion is known far
/// below the pixels' noise; the pixels' detail is averaged on top of it.
class MotionField {
 public:
  static constexpr int kCell_px = 16;

  MotionField(int width_px, int height_px, bool breathing);

  [[nodiscard]] int columns() const noexcept { return columns_; }
  [[nodiscard]] int rows() const noexcept { return rows_; }

  /// Expected change of each cell's depth over the next `dt_s`. Call once for each frame, before correct().
  [[nodiscard]] const std::vector<float>& predict(double dt_s);
  /// The cells' whole innovations, smoothed, of which correct() takes its share: the motion is the cells' to follow, so
  /// that pixels must not take it into their averages.
  [[nodiscard]] const std::vector<float>& innovations() const noexcept { return innovation_; }
  /// Takes in what was seen; answers with each cell's correction to the prediction.
  [[nodiscard]] const std::vector<float>& correct(const std::vector<CellInnovation>& seen, double dt_s);

  /// Terms of the motion of depth after the last frame at pixel (u, v), interpolated between cells.
  [[nodiscard]] MotionTerms terms_at(double u, double v) const noexcept;
  [[nodiscard]] MotionModel model() const noexcept;

 private:
  [[nodiscard]] CellInnovation smoothed(const std::vector<CellInnovation>& seen, int column, int row) const noexcept;
  void correct_cell(std::size_t at, const CellInnovation& innovation, double dt_s) noexcept;
  [[nodiscard]] double believed() const noexcept { return breathing_wanted_ ? breathing_.confidence() : 0.0; }
  void update_terms();

  struct Cell {
    double velocity_m_per_s = 0.0;
    double energy = 0.0;  ///< slow mean of the squared velocity: what moves leads the breathing model
    double frames = 0.0;
    double lean_m = 0.0;  ///< running mean of the innovation: what the filter fails to follow
  };

  int columns_;
  int rows_;
  bool breathing_wanted_;
  std::vector<Cell> cells_;
  std::vector<float> displacement_;  ///< of each cell since the start [m]
  std::vector<float> observed_;  ///< the same, but as measured: what the breath is fitted to must not be its own echo
  std::vector<float> weight_;
  std::vector<float> change_;
  std::vector<float> correction_;
  std::vector<float> innovation_;
  std::vector<MotionTerms> terms_;
  BreathingModel breathing_;
  double miss_m_ = 0.0;  ///< running mean of |innovation| of what moves
  double frame_s_ = 0.033;
};

}  // namespace telepalp::surface
