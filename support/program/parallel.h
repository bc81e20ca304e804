#pragma once

#include <functional>

namespace telepalp::program {

/// Number of processors that this process may use, at least 1.
[[nodiscard]] int processors() noexcept;

/// Calls `run(i)` for i in [0, count), each i once and in no fixed order, on the calling thread and up to
/// `threads` - 1 others. Returns when all calls have returned. What `run` writes for one i must not be read or written
/// for another.
void for_each_parallel(int count, int threads, const std::function<void(int)>& run);

}  // namespace telepalp::program
