#include "tests/support/no_heap_scope.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TELEPALP_INTERPOSES_MALLOC 0
#else
#define TELEPALP_INTERPOSES_MALLOC 1
#endif

namespace {

thread_local int forbidden = 0;
std::atomic<std::uint64_t> calls{0};
std::atomic<std::uint64_t> bytes{0};

}  // namespace

namespace telepalp::test {

NoHeapScope::NoHeapScope() noexcept { ++forbidden; }
NoHeapScope::~NoHeapScope() { --forbidden; }
HeapUse heap_use() noexcept { return {calls.load(), bytes.load()}; }
bool NoHeapScope::works() noexcept { return TELEPALP_INTERPOSES_MALLOC != 0; }

}  // namespace telepalp::test

#if TELEPALP_INTERPOSES_MALLOC

// These definitions replace libc's in the program and in every library. glibc exports its own functions under these
// names for this purpose.
extern "C" {
void* __libc_malloc(std::size_t) noexcept;
void* __libc_calloc(std::size_t, std::size_t) noexcept;
void* __libc_realloc(void*, std::size_t) noexcept;
void* __libc_memalign(std::size_t, std::size_t) noexcept;
void __libc_free(void*) noexcept;

static void refuse_where_forbidden(const char* what) noexcept {
  if (forbidden == 0) return;
  forbidden = 0;  // the following code may use the heap
  [[maybe_unused]] auto written = write(STDERR_FILENO, what, std::strlen(what));
  written = write(STDERR_FILENO, " used where the heap is forbidden\n", 34);
  std::abort();
}

static void count(std::size_t size) noexcept {
  calls.fetch_add(1, std::memory_order_relaxed);
  bytes.fetch_add(size, std::memory_order_relaxed);
}

void* malloc(std::size_t size) noexcept {
  refuse_where_forbidden("malloc");
  count(size);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
  refuse_where_forbidden("calloc");
  count(number * size);
  return __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  refuse_where_forbidden("realloc");
  count(size);
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("memalign");
  count(size);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("aligned_alloc");
  count(size);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("posix_memalign");
  count(size);
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
void free(void* old) noexcept {
  if (old != nullptr) refuse_where_forbidden("free");
  __libc_free(old);
}
}

#endif
