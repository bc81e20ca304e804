#pragma once

#include <Eigen/Core>
#include <array>
#include <deque>
#include <span>
#include <vector>

#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// A cell's innovation in a frame: measured minus predicted change of depth.
struct SharedInnovation {
  double m = 0.0;
  double sigma_m = 0.0;  ///< 1-sigma of `m` under noise alone; 0: not measured
};

/// The prediction for a cell at the next frame, without the cell's velocity relative to the shared motion.
struct SharedPrediction {
  double change_m = 0.0;  ///< change of depth since the last frame
  double speed_m_per_s = 0.0;
  double acceleration_m_per_s2 = 0.0;
};

/// The motion common to the whole body, such as a breath or a cough: one displacement over time. Each cell moves by a
/// learned share (factor) of this displacement. All cells serve to estimate it, so its speed and acceleration are known
/// far better than those of one cell. The weights of its predictions are learned by comparing past predictions with the
/// motion that followed. Owner: surface thread.
class SharedMotion {
 public:
  explicit SharedMotion(std::size_t cells);

  /// Advances the motion by `dt_s` to the weighted mean of the cells' predictions. `rad_per_s`: angular frequency of
  /// the oscillation that predictions continue from speed and acceleration; an oscillation bounds what they predict.
  void predict(std::span<const SharedPrediction> cells, double dt_s, double rad_per_s) noexcept;
  /// Updates the motion with a frame's innovations. Cells that deviate from the others get a small weight. If fewer
  /// than 85 % of the measured cells agree, the motion is not shared (the camera was pushed): all estimates start anew,
  /// and unmodelled() is 1.
  void correct(std::span<const SharedInnovation> seen, double dt_s);
  /// Learns the shares of the cells from the measured change of each cell's depth since the first frame [m].
  void learn(std::span<const float> displacement_m, double dt_s);

  /// The cell's displacement per shared displacement, by linear regression; 1 at the start.
  [[nodiscard]] double share(std::size_t cell) const noexcept { return share_[cell]; }
  [[nodiscard]] double innovation_m() const noexcept { return innovation_m_; }  ///< of the last frame
  [[nodiscard]] double corrected_m() const noexcept {
    return corrected_m_;
  }  ///< the part of innovation_m() that the filter added to the displacement
  [[nodiscard]] double speed_m_per_s() const noexcept { return speed_m_per_s_; }
  [[nodiscard]] double acceleration_m_per_s2() const noexcept { return acceleration_m_per_s2_; }
  /// Weights of the predictions from speed and from acceleration, learned over the last ten seconds. A motion much
  /// faster than usual, as when the patient shifts, may end at any time: meanwhile, the weight of the speed is at most
  /// the one learned over the last half second, and the weight of the acceleration is 0.
  [[nodiscard]] ForesightShare speed_share() const noexcept;
  [[nodiscard]] ForesightShare acceleration_share() const noexcept;
  /// 1 while the motion is much faster than usual, or not shared by the whole body. Afterwards the value falls to 0
  /// within 1 s.
  [[nodiscard]] double unmodelled() const noexcept { return unmodelled_; }

 private:
  struct Moments {
    double mean_m = 0.0;
    double with_shared_m2 = 0.0;  ///< covariance with the shared displacement
  };
  struct Past {
    double at_s;
    double shared_m;
    double speed_m_per_s;
    double acceleration_m_per_s2;
  };
  /// Least-squares regression of the measured motion on the motions predicted from speed and from acceleration.
  struct Judge {
    double ahead_s = 0.0;  ///< age of the prediction
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d came = Eigen::Vector2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Ones();  ///< the regression's coefficients, in [0, 1]
    double lately_said_m2 = 0.0;  ///< sums of the regression on speed alone, over the last half second
    double lately_came_m2 = 0.0;
  };
  struct Estimate {
    double m = 0.0;
    double sigma_m = 1.0;
    bool agreed = true;
  };

  [[nodiscard]] double median_m(std::span<const SharedInnovation> seen);
  [[nodiscard]] Estimate estimate_of(std::span<const SharedInnovation> seen);
  void judge_pace(double dt_s) noexcept;
  void judge(Judge& one, double dt_s) noexcept;

  std::vector<double> share_;
  std::vector<Moments> moments_;
  std::vector<double> said_m_;  ///< buffer of median_m()
  double mean_m_ = 0.0;         ///< of the shared displacement
  double variance_m2_ = 0.0;    ///< of the shared displacement
  double learned_s_ = 0.0;      ///< time over which the shares were learned
  double now_s_ = 0.0;
  double rad_per_s_ = 1.0;
  double shared_m_ = 0.0;  ///< displacement since the first frame
  double speed_m_per_s_ = 0.0;
  double acceleration_m_per_s2_ = 0.0;
  double innovation_m_ = 0.0;
  double corrected_m_ = 0.0;
  double lean_m_ = 0.0;           ///< running mean of the innovations
  double mean_pace_m_per_s_ = 0;  ///< running mean of |speed| + 0.1 s · |acceleration|
  double usual_ = 1.0;            ///< 1 while the pace is like its running mean, 0 while it is much greater
  double unmodelled_ = 0.0;
  std::deque<Past> past_;
  std::array<Judge, kForesightAges_s.size()> judges_;
};

}  // namespace telepalp::surface
