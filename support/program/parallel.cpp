#include "support/program/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace telepalp::program {

int processors() noexcept { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void for_each_parallel(int count, int threads, const std::function<void(int)>& run) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) run(i);
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(work);
  work();
}

}  // namespace telepalp::program
