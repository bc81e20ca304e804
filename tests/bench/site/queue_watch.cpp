#include "tests/bench/site/queue_watch.h"

#include <linux/gen_stats.h>
#include <linux/netlink.h>
#include <linux/pkt_sched.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <optional>

#include "proto/words/demand.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

constexpr auto kLookEvery = 5ms;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"  // in the macros of the kernel's headers

struct Request {
  nlmsghdr head{};
  tcmsg about{};
};

/// The attribute `wanted` among those in `length` bytes from `first` on; null: not there.
const rtattr* attribute(const rtattr* first, int length, unsigned short wanted) {
  for (const rtattr* next = first; RTA_OK(next, length); next = RTA_NEXT(next, length))
    if ((next->rta_type & NLA_TYPE_MASK) == wanted) return next;
  return nullptr;
}

/// Bytes in the root queue that a reply (rtnetlink(7), RTM_NEWQDISC) tells; nullopt: it tells of another one.
std::optional<std::uint32_t> backlog_B(const nlmsghdr* reply) {
  if (reply->nlmsg_type != RTM_NEWQDISC) return std::nullopt;
  const auto* about = static_cast<const tcmsg*>(NLMSG_DATA(reply));
  if (about->tcm_parent != TC_H_ROOT) return std::nullopt;
  const rtattr* all = attribute(TCA_RTA(about), static_cast<int>(TCA_PAYLOAD(reply)), TCA_STATS2);
  if (all == nullptr) return std::nullopt;
  const rtattr* queue =
      attribute(static_cast<const rtattr*>(RTA_DATA(all)), static_cast<int>(RTA_PAYLOAD(all)), TCA_STATS_QUEUE);
  if (queue == nullptr) return std::nullopt;
  gnet_stats_queue counts{};
  std::memcpy(&counts, RTA_DATA(queue), std::min<std::size_t>(sizeof counts, RTA_PAYLOAD(queue)));
  return counts.backlog;
}

/// Asks the kernel once; nullopt: no answer.
std::optional<std::uint32_t> ask(int socket, int device) {
  Request request;
  request.head = {.nlmsg_len = sizeof request,
                  .nlmsg_type = RTM_GETQDISC,
                  .nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP,
                  .nlmsg_seq = 0,
                  .nlmsg_pid = 0};
  request.about.tcm_family = AF_UNSPEC;
  request.about.tcm_ifindex = device;
  if (::send(socket, &request, sizeof request, 0) < 0) return std::nullopt;
  std::optional<std::uint32_t> found;
  alignas(nlmsghdr) std::array<char, 16384> buffer{};
  for (bool more = true; more;) {
    const ssize_t got = ::recv(socket, buffer.data(), buffer.size(), 0);
    if (got <= 0) return found;
    auto left = static_cast<unsigned>(got);
    for (auto* reply = reinterpret_cast<nlmsghdr*>(buffer.data()); NLMSG_OK(reply, left);
         reply = NLMSG_NEXT(reply, left)) {
      if (reply->nlmsg_type == NLMSG_DONE || reply->nlmsg_type == NLMSG_ERROR)
        more = false;
      else if (const auto bytes = backlog_B(reply))
        found = bytes;
    }
  }
  return found;
}

#pragma GCC diagnostic pop

}  // namespace

Nanoseconds wall_clock() noexcept { return std::chrono::system_clock::now().time_since_epoch(); }

QueueWatch::QueueWatch(const TwoNetworks& networks, const SiteLine& line) : line_B_per_s_(line.Mbit_per_s * 1e6 / 8.0) {
  reader_ = networks.run(TwoNetworks::Side::Patient, [this](auto stop) { read(stop); });
}

void QueueWatch::read(const std::stop_token& stop) {
  const int socket = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
  demand(socket >= 0, "the kernel's queues can be asked");
  const int device = static_cast<int>(::if_nametoindex("site"));
  for (; !stop.stop_requested(); std::this_thread::sleep_for(kLookEvery)) {
    const std::optional<std::uint32_t> bytes = ask(socket, device);
    if (!bytes) continue;
    const std::lock_guard lock(mutex_);
    readings_.push_back({wall_clock(), from_seconds(*bytes / line_B_per_s_)});
  }
  ::close(socket);
}

Nanoseconds QueueWatch::at(Nanoseconds at) const {
  const std::lock_guard lock(mutex_);
  const auto after =
      std::ranges::upper_bound(readings_, at, std::ranges::less{}, [](const Reading& reading) { return reading.at; });
  return after == readings_.begin() ? 0ns : std::prev(after)->queue;
}

Distribution QueueWatch::between_ms(Nanoseconds from, Nanoseconds until) const {
  const std::lock_guard lock(mutex_);
  Distribution within;
  for (const Reading& reading : readings_)
    if (reading.at >= from && reading.at < until) within.add(to_milliseconds(reading.queue));
  return within;
}

}  // namespace telepalp::bench
