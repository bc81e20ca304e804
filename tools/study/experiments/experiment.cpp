#include "tools/study/experiments/experiment.h"

#include <algorithm>
#include <numeric>

#include "tools/study/figures/shuffle.h"

namespace telepalp::study {

std::vector<std::size_t> order_of(std::uint64_t seed, std::size_t observer, std::size_t conditions) {
  std::vector<std::vector<std::size_t>> orders(1, std::vector<std::size_t>(conditions));
  std::iota(orders[0].begin(), orders[0].end(), std::size_t{0});
  for (std::vector<std::size_t> next = orders[0]; std::next_permutation(next.begin(), next.end());)
    orders.push_back(next);
  device::Random random(seed_of(seed, kOrders, observer / orders.size()));
  return orders[shuffled(orders.size(), random)[observer % orders.size()]];
}

}  // namespace telepalp::study
