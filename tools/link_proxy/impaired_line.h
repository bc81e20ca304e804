#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <map>
#include <span>

#include "proto/impaired/impaired_link.h"

namespace telepalp::link_proxy {

/// One direction of the proxy in real time: all flows (TCP connections and UDP clients) share one impaired link. When a
/// packet has passed the link, the sink of the packet's flow is called. Owner: the thread of `io`.
class ImpairedLine {
 public:
  using Sink = std::function<void(std::vector<std::byte> bytes)>;

  ImpairedLine(boost::asio::io_context& io, impaired::ImpairedLink link);

  void open(std::uint64_t flow, Sink sink) { sinks_[flow] = std::move(sink); }
  /// Packets of `flow` that have not arrived are discarded on arrival.
  void close(std::uint64_t flow) {
    sinks_.erase(flow);
    link_.forget_stream(flow);
  }

  void send_datagram(std::uint64_t flow, std::span<const std::byte> bytes) { send(flow, bytes, false); }
  /// An empty segment marks the end of the stream.
  void send_segment(std::uint64_t flow, std::span<const std::byte> bytes) { send(flow, bytes, true); }
  [[nodiscard]] bool has_room(std::size_t bytes) const { return link_.has_room(now(), bytes); }

  [[nodiscard]] std::size_t queued_B() const { return link_.queued_B(now()); }
  [[nodiscard]] const impaired::LinkStatistics& statistics() const noexcept { return link_.statistics(); }

 private:
  [[nodiscard]] Nanoseconds now() const { return std::chrono::steady_clock::now() - started_; }
  void send(std::uint64_t flow, std::span<const std::byte> bytes, bool stream);
  void deliver();
  void wait_for_next();

  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  impaired::ImpairedLink link_;
  boost::asio::steady_timer timer_;
  std::map<std::uint64_t, Sink> sinks_;
};

}  // namespace telepalp::link_proxy
