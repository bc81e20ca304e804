#include "tests/bench/accuracy/accuracy_pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace telepalp::bench {

std::vector<std::size_t> pareto_front(std::span<const Tradeoff> all) {
  std::vector<std::size_t> by_cost;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::isfinite(all[i].error) && std::isfinite(all[i].cost)) by_cost.push_back(i);
  std::sort(by_cost.begin(), by_cost.end(), [&](std::size_t a, std::size_t b) {
    return all[a].cost != all[b].cost ? all[a].cost < all[b].cost : all[a].error < all[b].error;
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : by_cost)
    if (all[i].error < least) {
      front.push_back(i);
      least = all[i].error;
    }
  return front;
}

std::size_t knee_of(std::span<const Tradeoff> all) {
  std::size_t knee = all.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].allowed && all[i].error * all[i].cost < least) {
      least = all[i].error * all[i].cost;
      knee = i;
    }
  return knee;
}

}  // namespace telepalp::bench
