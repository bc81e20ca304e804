#pragma once

#include <cstdint>

namespace telepalp::test {

/// Allocations of all threads since the program's start; always zero if NoHeapScope::works() is false.
struct HeapUse {
  std::uint64_t calls = 0;
  std::uint64_t bytes = 0;
  friend bool operator==(const HeapUse&, const HeapUse&) = default;
  friend HeapUse operator-(const HeapUse& a, const HeapUse& b) { return {a.calls - b.calls, a.bytes - b.bytes}; }
};
[[nodiscard]] HeapUse heap_use() noexcept;

/// While one lives, any use of the heap by this thread aborts with a message: malloc and its kin, and so also
/// operator new, Eigen and the standard library. `free(nullptr)` is allowed.
class NoHeapScope {
 public:
  NoHeapScope() noexcept;
  ~NoHeapScope();
  NoHeapScope(const NoHeapScope&) = delete;
  NoHeapScope& operator=(const NoHeapScope&) = delete;

  /// False under a sanitizer, which owns malloc itself: skip the test then.
  [[nodiscard]] static bool works() noexcept;
};

}  // namespace telepalp::test
