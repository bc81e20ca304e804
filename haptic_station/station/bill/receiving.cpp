#include "haptic_station/station/bill/receiving.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "haptic_station/station/bill/thread_time.h"
#include "proto/wire/datagram_message.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;
using boost::asio::ip::udp;

/// A server's and a station's end of the datagrams, each with a socket, on one thread.
class LoopbackLink {
 public:
  LoopbackLink() {
    to_station_.connect(station_socket_.local_endpoint());
    station_socket_.connect(to_station_.local_endpoint());
  }

  /// Sends `image`, and returns true when the station's end has it.
  bool carry(const wire::Message& image) {
    server_.offer(wire::frame_of(image, now_));
    for (int ms = 0; ms < 100; ++ms, now_ += 1ms) {
      while (const std::optional<link::Datagram> datagram = server_.next(now_)) {
        to_station_.send(boost::asio::buffer(datagram->bytes().data(), datagram->size));
        if (at_station()) return true;
      }
    }
    return false;
  }
  void wait_until(SessionTime now) noexcept { now_ = now; }
  [[nodiscard]] double spent_us() const noexcept { return 1e-3 * static_cast<double>(spent_ns_); }

 private:
  /// What the station does with one datagram. Returns true when it completes an image.
  bool at_station() {
    const std::int64_t before = thread_ns();
    const std::size_t size = station_socket_.receive(boost::asio::buffer(buffer_));
    (void)station_.received(std::span(buffer_).first(size), now_);
    const std::optional<link::Frame> frame = station_.take(now_);
    const bool is_whole = frame && wire::message_of(*frame).has_value();
    std::optional<link::Datagram> report = station_.next(now_);
    if (report) station_socket_.send(boost::asio::buffer(report->bytes().data(), report->size));
    spent_ns_ += thread_ns() - before - thread_clock_ns();
    if (report) {
      const std::size_t answered = to_station_.receive(boost::asio::buffer(buffer_));
      (void)server_.received(std::span(buffer_).first(answered), now_);
    }
    return is_whole;
  }

  boost::asio::io_context io_{1};
  udp::socket to_station_{io_, udp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  udp::socket station_socket_{io_, udp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  link::DatagramLink server_{{}, link::End::Server};
  link::DatagramLink station_{{}, link::End::Client};
  std::array<std::byte, link::kDatagramBytes> buffer_{};
  SessionTime now_{};
  std::int64_t spent_ns_ = 0;
};

}  // namespace

double receiving_us(std::span<const wire::Message> images) {
  LoopbackLink link;
  int carried = 0;
  for (wire::Message image : images) {
    image.sequence = static_cast<std::uint64_t>(carried) + 1;
    link.wait_until(image.published);
    if (link.carry(image)) ++carried;
  }
  return carried == 0 ? 0.0 : link.spent_us() / carried;
}

}  // namespace telepalp::station
