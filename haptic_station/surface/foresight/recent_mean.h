#pragma once

#include <deque>
#include <span>
#include <vector>

namespace telepalp::surface {

/// The mean place of each cell over the last 2 s. Skin that swings faster than images arrive, as while a patient talks,
/// is more often near this mean than near the place that the newest image shows. Owner: surface thread.
class RecentMean {
 public:
  explicit RecentMean(std::size_t cells) : sum_m_s_(cells, 0.0) {}

  /// Adds a frame, `dt_s` after the last one. `displacement_m`: change of each cell's depth since the first frame.
  void add(std::span<const float> displacement_m, double dt_s);
  /// The mean change of the cell's depth since the first frame [m]; 0 before any frame. Each frame counts by the time
  /// since the frame before it.
  [[nodiscard]] double m(std::size_t cell) const noexcept { return lasts_s_ > 0.0 ? sum_m_s_[cell] / lasts_s_ : 0.0; }

 private:
  struct Past {
    double lasts_s;
    std::vector<float> displacement_m;
  };
  std::deque<Past> past_;
  std::vector<double> sum_m_s_;  ///< of each cell's displacement times the time that it counts for
  double lasts_s_ = 0.0;
};

}  // namespace telepalp::surface
