#include "tools/link_proxy/tcp_pair.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <span>
#include <utility>

namespace telepalp::link_proxy {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using namespace std::chrono_literals;

constexpr std::size_t kSegment_B = 1400;
constexpr std::size_t kMostOnTheWay_B = std::size_t{4} << 20U;  ///< bytes kept for a receiver that does not read
constexpr auto kLookAgain = 1ms;  ///< pause before the next check for room in the bottleneck's queue

}  // namespace

TcpPair::TcpPair(asio::io_context& io, std::shared_ptr<Lines> lines, Socket client, std::function<void()> on_closed)
    : lines_(std::move(lines)),
      flow_(lines_->new_flow()),
      client_(std::move(client)),
      server_(io),
      on_closed_(std::move(on_closed)),
      up_{client_, server_, lines_->to_server, asio::steady_timer(io)},
      down_{server_, client_, lines_->to_client, asio::steady_timer(io)} {}

TcpPair::~TcpPair() {
  up_.line.close(flow_);
  down_.line.close(flow_);
}

void TcpPair::start(const tcp::endpoint& server) {
  server_.async_connect(server, [self = shared_from_this()](const error_code& failed) {
    if (failed) return self->close();
    self->client_.set_option(tcp::no_delay(true));
    self->server_.set_option(tcp::no_delay(true));
    for (Way* way : {&self->up_, &self->down_}) self->open(*way);
  });
}

void TcpPair::open(Way& way) {
  way.line.open(flow_, [pair = weak_from_this(), &way](std::vector<std::byte> segment) {
    const auto self = pair.lock();
    if (!self) return;
    way.to_write.push_back(std::move(segment));
    if (!way.writing) self->write(way);
  });
  read(way);
}

void TcpPair::close() {
  if (!on_closed_) return;
  error_code ignored;
  client_.close(ignored);
  server_.close(ignored);
  up_.room_timer.cancel();
  down_.room_timer.cancel();
  std::exchange(on_closed_, nullptr)();
}

void TcpPair::read(Way& way) {
  if (!way.line.has_room(way.read_buffer.size()) || way.on_the_way_B > kMostOnTheWay_B) {
    way.room_timer.expires_after(kLookAgain);
    way.room_timer.async_wait([self = shared_from_this(), &way](const error_code& cancelled) {
      if (!cancelled) self->read(way);
    });
    return;
  }
  way.from.async_read_some(asio::buffer(way.read_buffer),
                           [self = shared_from_this(), &way](const error_code& failed, std::size_t bytes) {
                             if (failed == asio::error::eof) return way.line.send_segment(self->flow_, {});
                             if (failed) return self->close();
                             self->send(way, bytes);
                             self->read(way);
                           });
}

void TcpPair::send(Way& way, std::size_t bytes) {
  way.on_the_way_B += bytes;
  for (std::span<const std::byte> rest(way.read_buffer.data(), bytes); !rest.empty();) {
    const std::size_t segment = std::min(rest.size(), kSegment_B);
    way.line.send_segment(flow_, rest.first(segment));
    rest = rest.subspan(segment);
  }
}

void TcpPair::write(Way& way) {
  way.writing = false;
  if (way.to_write.empty()) return;
  if (way.to_write.front().empty()) return end_of_stream(way);
  way.writing = true;
  asio::async_write(way.to, asio::buffer(way.to_write.front()),
                    [self = shared_from_this(), &way](const error_code& failed, std::size_t bytes) {
                      if (failed) return self->close();
                      way.on_the_way_B -= bytes;
                      way.to_write.pop_front();
                      self->write(way);
                    });
}

void TcpPair::end_of_stream(Way& way) {
  way.ended = true;
  error_code ignored;
  way.to.shutdown(tcp::socket::shutdown_send, ignored);
  if (up_.ended && down_.ended) close();
}

}  // namespace telepalp::link_proxy
