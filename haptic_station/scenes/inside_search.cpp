#include "haptic_station/scenes/inside_search.h"

#include <queue>

namespace telepalp::scenes {
namespace {

constexpr int kMostPoints = 20'000;
constexpr double kSmallest_m = 1e-5;

struct Part {
  solids::Box box;
  double m;  ///< the solid's value at the box's middle
};
struct Farther {
  bool operator()(const Part& a, const Part& b) const noexcept { return a.m > b.m; }
};

}  // namespace

Search find_inside(const solids::SolidTree& tree, const solids::Box& box) {
  std::priority_queue<Part, std::vector<Part>, Farther> parts;
  int points = 0;
  const auto add = [&](const solids::Box& part) {
    const double m = solid_at(tree, 0.5 * (part.low + part.high)).m;
    const double reach_m = 0.5 * (part.high - part.low).norm();
    ++points;
    if (m <= tree.steepest * reach_m && reach_m > kSmallest_m) parts.push({part, m});
    return m < 0.0;
  };
  if (add(box)) return Search::Inside;
  while (!parts.empty()) {
    if (points >= kMostPoints) return Search::Unknown;
    const solids::Box whole = parts.top().box;
    parts.pop();
    Eigen::Index axis = 0;
    (whole.high - whole.low).maxCoeff(&axis);
    solids::Box low = whole, high = whole;
    low.high[axis] = high.low[axis] = 0.5 * (whole.low[axis] + whole.high[axis]);
    if (add(low) || add(high)) return Search::Inside;
  }
  return Search::NothingInside;
}

}  // namespace telepalp::scenes
