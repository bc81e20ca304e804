#include "tests/bench/hand/options.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

namespace telepalp::bench::hand {

void for_each_parallel(int count, const Options& options, const std::function<void(int)>& run) {
  std::atomic<int> next{0};
  std::mutex printing;
  int done = 0;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) {
      run(i);
      const std::lock_guard lock(printing);
      options.progress(++done, count);
    }
  };
  std::vector<std::jthread> threads;
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int i = 1; i < std::min(processors, count); ++i) threads.emplace_back(work);
  work();
}

}  // namespace telepalp::bench::hand
