#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace telepalp::bench::hand {

/// Options of every study.
struct Options {
  int seeds = 200;
  std::function<void(int done, int of)> progress = [](int, int) {};  ///< called by any thread, but never by two at once
};

/// Calls `run(i)` for i in [0, count) on all processors, each i once, in no fixed order. What `run` writes for one i
/// must not be read or written for another.
void for_each_parallel(int count, const Options& options, const std::function<void(int)>& run);

}  // namespace telepalp::bench::hand
