#include "tools/link_proxy/impaired_line.h"

#include <utility>

namespace telepalp::link_proxy {

ImpairedLine::ImpairedLine(boost::asio::io_context& io, impaired::ImpairedLink link)
    : link_(std::move(link)), timer_(io) {}

void ImpairedLine::send(std::uint64_t flow, std::span<const std::byte> bytes, bool stream) {
  const std::optional<Nanoseconds> before = link_.next_arrival();
  link_.send(now(), {.bytes = {bytes.begin(), bytes.end()}, .flow = flow, .stream = stream});
  if (link_.next_arrival() != before) wait_for_next();
}

void ImpairedLine::wait_for_next() {
  const std::optional<Nanoseconds> next = link_.next_arrival();
  if (!next) return;
  timer_.expires_at(started_ + *next);
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled) deliver();
  });
}

void ImpairedLine::deliver() {
  while (std::optional<impaired::Packet> packet = link_.receive(now())) {
    const auto sink = sinks_.find(packet->flow);
    if (sink == sinks_.end()) continue;
    const Sink call = sink->second;  // a sink may close its flow
    call(std::move(packet->bytes));
  }
  wait_for_next();
}

}  // namespace telepalp::link_proxy
