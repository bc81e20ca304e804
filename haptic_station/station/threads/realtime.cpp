#include "haptic_station/station/threads/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>

namespace telepalp::station {
namespace {

// Above ordinary programs, below the kernel's own interrupt threads (50).
constexpr int kPriority = 40;

}  // namespace

Result<bool> enter_realtime(Realtime wanted) {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int scheduling = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  const int locking = mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? 0 : errno;
  if (scheduling == 0 && locking == 0) return true;
  if (wanted == Realtime::Prefer) return false;
  return Error{.what = std::string("no real-time priority or locked memory: ") +
                       std::strerror(scheduling != 0 ? scheduling : locking),
               .where = "telepalp-station",
               .fix =
                   "use the package's telepalp-station.service, or sudo setcap cap_sys_nice,cap_ipc_lock=ep "
                   "telepalp-station, or start with --realtime prefer"};
}

}  // namespace telepalp::station
