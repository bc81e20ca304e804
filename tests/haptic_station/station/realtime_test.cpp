#include "haptic_station/station/threads/realtime.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <thread>

namespace telepalp::station {
namespace {

/// Takes the right to lock memory from the calling thread.
void give_up_locking() {
  __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
  std::array<__user_cap_data_struct, 2> rights{};
  ASSERT_EQ(::syscall(SYS_capget, &header, rights.data()), 0);
  rights[0].effective &= ~(1U << CAP_IPC_LOCK);
  ASSERT_EQ(::syscall(SYS_capset, &header, rights.data()), 0);
}

/// No memory may be locked while it lives, as under `ulimit -l 0`.
struct NoLockableMemory {
  rlimit before{};
  NoLockableMemory() {
    ::getrlimit(RLIMIT_MEMLOCK, &before);
    rlimit none = before;
    none.rlim_cur = 0;
    ::setrlimit(RLIMIT_MEMLOCK, &none);
  }
  ~NoLockableMemory() { ::setrlimit(RLIMIT_MEMLOCK, &before); }
};

TEST(Realtime, WithoutLockedMemoryThePriorityIsStillStatedAsItIs) {
  const NoLockableMemory limit;
  std::thread([] {  // a thread of its own, because its priority and rights change
    give_up_locking();
    if (::mlockall(MCL_CURRENT) == 0) GTEST_SKIP() << "a sanitizer ignores mlockall()";
    const auto granted = enter_realtime(Realtime::Prefer);
    ASSERT_TRUE(granted.ok());
    EXPECT_EQ(granted->priority, ::sched_getscheduler(0) == SCHED_FIFO);
    EXPECT_FALSE(granted->locked_memory);
    const auto required = enter_realtime(Realtime::Require);
    ASSERT_FALSE(required.ok());
    EXPECT_EQ(required.error().what.find("no real-time priority") == std::string::npos, granted->priority)
        << required.error().what;
    EXPECT_NE(required.error().what.find("no locked memory ("), std::string::npos) << required.error().what;
  })
      .join();
}

TEST(Realtime, SaysEachOfBothTruthfully) {
  EXPECT_EQ(in_words({.priority = true, .locked_memory = true}), "with real-time priority and locked memory");
  EXPECT_EQ(in_words({.priority = true, .locked_memory = false}), "with real-time priority, without locked memory");
  EXPECT_EQ(in_words({.priority = false, .locked_memory = true}), "with locked memory, without real-time priority");
  EXPECT_EQ(in_words({.priority = false, .locked_memory = false}), "without real-time priority or locked memory");
}

}  // namespace
}  // namespace telepalp::station
