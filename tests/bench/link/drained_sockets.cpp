#include "tests/bench/link/drained_sockets.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <boost/asio/write.hpp>

namespace telepalp::bench {

DrainedSockets::DrainedSockets(std::uint16_t port, std::size_t count, const std::string& first_words) {
  for (std::size_t i = 0; i < count; ++i) {
    sockets_.emplace_back(io_).connect({boost::asio::ip::address_v4::loopback(), port});
    boost::asio::write(sockets_.back(), boost::asio::buffer(first_words));
    bytes_.emplace_back(0);
  }
  thread_ = std::thread([this] { drain(); });
}

DrainedSockets::~DrainedSockets() {
  ended_ = true;
  thread_.join();
}

void DrainedSockets::drain() {
  const int poll = ::epoll_create1(0);
  for (std::size_t i = 0; i < sockets_.size(); ++i) {
    epoll_event event{.events = EPOLLIN, .data = {.u64 = i}};
    ::epoll_ctl(poll, EPOLL_CTL_ADD, sockets_[i].native_handle(), &event);
  }
  constexpr std::size_t kMost = std::size_t{4} << 20U;
  std::array<epoll_event, 64> events{};
  while (!ended_) {
    const int ready = ::epoll_wait(poll, events.data(), events.size(), 20);
    for (int i = 0; i < ready; ++i) {
      const std::size_t at = events[static_cast<std::size_t>(i)].data.u64;
      // With MSG_TRUNC the kernel drops the bytes of a TCP socket instead of copying them (tcp(7)).
      const ssize_t got = ::recv(sockets_[at].native_handle(), nullptr, kMost, MSG_TRUNC | MSG_DONTWAIT);
      if (got > 0) bytes_[at] += static_cast<std::uint64_t>(got);
      if (got == 0) ::epoll_ctl(poll, EPOLL_CTL_DEL, sockets_[at].native_handle(), nullptr);
    }
  }
  ::close(poll);
}

std::vector<std::uint64_t> DrainedSockets::bytes() const { return {bytes_.begin(), bytes_.end()}; }

}  // namespace telepalp::bench
