#include "tools/study/run/block_order.h"

#include "tools/study/figures/shuffle.h"
#include "tools/study/run/seeds.h"

namespace telepalp::study {

BlockOrder block_order(std::uint64_t seed, std::size_t number, Condition condition, std::size_t mechanisms) {
  device::Random random(seed_of(seed, kOrder * 1000 + number, static_cast<std::uint64_t>(condition)));
  BlockOrder order{.first_guess = random.normal(), .training = {}, .formal = {}};
  order.training = shuffled(mechanisms, random);
  order.formal = shuffled(mechanisms, random);
  return order;
}

}  // namespace telepalp::study
