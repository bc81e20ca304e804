#pragma once

#include <deque>
#include <span>
#include <vector>

namespace telepalp::surface {

/// How far the skin moved within the last half second. Owner: surface thread.
class RecentWay {
 public:
  /// Adds a frame. `displacement_m`: change of each cell's depth since the first frame. `weight`: weight of each cell
  /// in m().
  void add(std::span<const float> displacement_m, std::span<const float> weight, double dt_s);
  /// The greatest distance between the skin now and the skin at an instant of the last half second: the weighted root
  /// mean square over the cells [m].
  [[nodiscard]] double m() const noexcept { return m_; }

 private:
  struct Past {
    double at_s;
    std::vector<float> displacement_m;
  };
  std::deque<Past> past_;
  double now_s_ = 0.0;
  double m_ = 0.0;
};

/// The age [s] from which a prediction at `speed_m_per_s` slows down (MotionModel::freeze_from_s), so that it moves the
/// surface by at most `way_m` in all; at least 1 ms, at most `longest_s`.
[[nodiscard]] double freeze_within(double way_m, double speed_m_per_s, double longest_s) noexcept;

}  // namespace telepalp::surface
