#include "tests/bench/site/bulk_flow.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "proto/words/demand.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kPageEvery = 5s;
constexpr timeval kLook{.tv_sec = 0, .tv_usec = 100'000};  ///< how often a blocked call looks whether to end

sockaddr_in address_of(const char* host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  ::inet_pton(AF_INET, host, &address.sin_addr);
  return address;
}

int new_socket() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  demand(socket >= 0, "a TCP socket can be made");
  for (const int limit : {SO_RCVTIMEO, SO_SNDTIMEO}) ::setsockopt(socket, SOL_SOCKET, limit, &kLook, sizeof kLook);
  return socket;
}

}  // namespace

BulkFlow::BulkFlow(const TwoNetworks& networks, Kind kind, std::uint16_t port) : kind_(std::move(kind)), port_(port) {
  using Side = TwoNetworks::Side;
  receiver_ = networks.run(kind_.upload ? Side::Patient : Side::Doctor, [this](auto stop) { receive(stop); });
  sender_ = networks.run(kind_.upload ? Side::Doctor : Side::Patient, [this](auto stop) { send(stop); });
}

BulkFlow::~BulkFlow() {
  sender_.request_stop();
  receiver_.request_stop();
}

void BulkFlow::receive(const std::stop_token& stop) {
  const int listener = new_socket();
  const sockaddr_in here = address_of(kind_.upload ? TwoNetworks::kPatient : TwoNetworks::kDoctor, port_);
  const int yes = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  demand(::bind(listener, reinterpret_cast<const sockaddr*>(&here), sizeof here) == 0 && ::listen(listener, 4) == 0,
         "the flow's port is free");
  std::vector<char> buffer(std::size_t{1} << 18U);
  while (!stop.stop_requested()) {
    const int from = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
    if (from < 0) continue;
    ::setsockopt(from, SOL_SOCKET, SO_RCVTIMEO, &kLook, sizeof kLook);
    for (ssize_t got = 1; got != 0 && !stop.stop_requested();) {
      got = ::recv(from, buffer.data(), buffer.size(), 0);
      if (got > 0) received_B_ += static_cast<std::uint64_t>(got);
    }
    ::close(from);
  }
  ::close(listener);
}

void BulkFlow::send_once(const std::stop_token& stop, int socket) {
  static const std::vector<char> kBlock(std::size_t{1} << 17U, 'x');
  std::uint64_t left = kind_.page_B > 0 ? kind_.page_B : UINT64_MAX;
  while (left > 0 && !stop.stop_requested()) {
    const ssize_t put = ::send(socket, kBlock.data(), std::min<std::uint64_t>(kBlock.size(), left), MSG_NOSIGNAL);
    if (put > 0) left -= static_cast<std::uint64_t>(put);
  }
}

void BulkFlow::send(const std::stop_token& stop) {
  const sockaddr_in there = address_of(kind_.upload ? TwoNetworks::kPatient : TwoNetworks::kDoctor, port_);
  while (!stop.stop_requested() && !unknown_) {
    const auto began = Clock::now();
    const int socket = new_socket();
    unknown_ = ::setsockopt(socket, IPPROTO_TCP, TCP_CONGESTION, kind_.congestion.data(),
                            static_cast<socklen_t>(kind_.congestion.size())) != 0;
    const bool joined = ::connect(socket, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
    if (joined && !unknown_) send_once(stop, socket);
    // What still waits in the socket is dropped when the flow ends, and sent when a page is complete.
    const linger drop{.l_onoff = stop.stop_requested() ? 1 : 0, .l_linger = 0};
    ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &drop, sizeof drop);
    ::close(socket);
    while (!stop.stop_requested() && joined && Clock::now() - began < kPageEvery) std::this_thread::sleep_for(20ms);
  }
}

}  // namespace telepalp::bench
