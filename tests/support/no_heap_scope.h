#pragma once

namespace telepalp::test {

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
