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

std::string said(const char* what, int failure) {
  return failure == 0 ? std::string() : std::string("no ") + what + " (" + std::strerror(failure) + ")";
}

}  // namespace

std::string in_words(const RealtimeGrant& grant) {
  if (grant.priority == grant.locked_memory)
    return grant.priority ? "with real-time priority and locked memory" : "without real-time priority or locked memory";
  return grant.priority ? "with real-time priority, without locked memory"
                        : "with locked memory, without real-time priority";
}

Result<RealtimeGrant> enter_realtime(Realtime wanted) {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int scheduling = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  const int locking = mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? 0 : errno;
  const RealtimeGrant grant{.priority = scheduling == 0, .locked_memory = locking == 0};
  if (grant.both() || wanted == Realtime::Prefer) return grant;
  return Error{.what = said("real-time priority", scheduling) + (grant.priority || grant.locked_memory ? "" : ", ") +
                       said("locked memory", locking),
               .where = "telepalp-station",
               .fix =
                   "use the package's telepalp-station.service, or run sudo adduser NAME telepalp-realtime (NAME: your "
                   "user) and sign in again, or start with --realtime prefer"};
}

}  // namespace telepalp::station
