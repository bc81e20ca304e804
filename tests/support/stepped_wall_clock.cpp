// A library to preload into a program: its wall clock is ahead by the number of seconds in the file that
// TELEPALP_WALL_CLOCK_STEP names. The file is mapped, so that a test steps the clock while the program runs. The
// monotonic clocks are not changed: a step of the wall clock does not change them either.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

std::int64_t step_s() noexcept {
  static const volatile std::int64_t* const shared = [] {
    const char* const name = std::getenv("TELEPALP_WALL_CLOCK_STEP");
    const int file = name == nullptr ? -1 : ::open(name, O_RDONLY | O_CLOEXEC);
    void* const mapped = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, file, 0);
    if (file >= 0) ::close(file);
    return mapped == MAP_FAILED ? nullptr : static_cast<const volatile std::int64_t*>(mapped);
  }();
  return shared == nullptr ? 0 : *shared;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* at) noexcept {
  const auto failed = static_cast<int>(::syscall(SYS_clock_gettime, clock, at));
  if (failed == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) at->tv_sec += step_s();
  return failed;
}

int gettimeofday(timeval* __restrict at, void* __restrict) noexcept {
  timespec now{};
  const int failed = clock_gettime(CLOCK_REALTIME, &now);
  *at = {.tv_sec = now.tv_sec, .tv_usec = now.tv_nsec / 1000};
  return failed;
}

std::time_t time(std::time_t* at) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (at != nullptr) *at = now.tv_sec;
  return now.tv_sec;
}

}  // extern "C"
