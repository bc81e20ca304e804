#include "tests/bench/hand/options.h"

#include <mutex>

#include "support/program/parallel.h"

namespace telepalp::bench::hand {

void for_each_parallel(int count, const Options& options, const std::function<void(int)>& run) {
  std::mutex printing;
  int done = 0;
  program::for_each_parallel(count, program::processors(), [&](int i) {
    run(i);
    const std::lock_guard lock(printing);
    options.progress(++done, count);
  });
}

}  // namespace telepalp::bench::hand
