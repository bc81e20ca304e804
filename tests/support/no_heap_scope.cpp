#include "tests/support/no_heap_scope.h"

#include <unistd.h>

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

}  // namespace

namespace telepalp::test {

NoHeapScope::NoHeapScope() noexcept { ++forbidden; }
NoHeapScope::~NoHeapScope() { --forbidden; }
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

void* malloc(std::size_t size) noexcept {
  refuse_where_forbidden("malloc");
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  refuse_where_forbidden("calloc");
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  refuse_where_forbidden("realloc");
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("memalign");
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("aligned_alloc");
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
  refuse_where_forbidden("posix_memalign");
  *out = __libc_memalign(alignment, size);
  return *out == nullptr ? ENOMEM : 0;
}
void free(void* old) noexcept {
  if (old != nullptr) refuse_where_forbidden("free");
  __libc_free(old);
}
}

#endif
