#pragma once

#include <algorithm>
#include <array>
#include <boost/asio/associated_executor.hpp>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/buffers_range.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/error.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <memory>
#include <type_traits>
#include <utility>

#include "proto/wire/tls_stream.h"
#include "server/gateway/sign_in/fragment_count.h"

namespace telepalp::gateway {

/// A browser's connection, over TLS or, on this machine, over plain TCP: an AsyncStream for Beast.
class WebStream {
 public:
  using executor_type = boost::beast::tcp_stream::executor_type;

  /// `settings` null: plain TCP.
  WebStream(boost::asio::ip::tcp::socket socket, wire::TlsSettings settings) : settings_(std::move(settings)) {
    if (settings_)
      tls_ = std::make_unique<Tls>(std::move(socket), *settings_);
    else
      plain_ = std::make_unique<boost::beast::tcp_stream>(std::move(socket));
  }

  [[nodiscard]] bool is_tls() const noexcept { return tls_ != nullptr; }
  boost::beast::tcp_stream& tcp() { return tls_ ? tls_->next_layer() : *plain_; }
  boost::asio::ip::tcp::socket& socket() { return tcp().socket(); }
  executor_type get_executor() { return tcp().get_executor(); }

  template <class Handler>
  void async_handshake(Handler&& handler) {
    tls_->async_handshake(boost::asio::ssl::stream_base::server, std::forward<Handler>(handler));
  }
  /// From now on the stream carries WebSocket frames: a read ends with kTooManyFragments when one message has more than
  /// FragmentCount::kMost fragments.
  void limit_fragments() { fragments_ = std::make_unique<FragmentCount>(); }
  static constexpr auto kTooManyFragments = boost::beast::websocket::error::bad_continuation;

  template <class Buffers, class Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    if (!fragments_) return read_some(buffers, std::forward<Handler>(handler));
    const auto executor = boost::asio::get_associated_executor(handler, get_executor());
    read_some(buffers,
              boost::asio::bind_executor(executor, [this, buffers, handler = std::forward<Handler>(handler)](
                                                       boost::system::error_code failed, std::size_t count) mutable {
                if (!count_fragments(buffers, count)) failed = kTooManyFragments;
                std::move(handler)(failed, count);
              }));
  }
  template <class Buffers, class Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    if (tls_) return void(tls_->async_write_some(buffers, std::forward<Handler>(handler)));
    plain_->async_write_some(buffers, std::forward<Handler>(handler));
  }

 private:
  using Tls = boost::asio::ssl::stream<boost::beast::tcp_stream>;

  template <class Buffers, class Handler>
  void read_some(const Buffers& buffers, Handler&& handler) {
    if (tls_) return void(tls_->async_read_some(buffers, std::forward<Handler>(handler)));
    plain_->async_read_some(buffers, std::forward<Handler>(handler));
  }
  /// False: with the first `count` bytes of `buffers`, a message has too many fragments.
  template <class Buffers>
  [[nodiscard]] bool count_fragments(const Buffers& buffers, std::size_t count) {
    for (const boost::asio::mutable_buffer part : boost::beast::buffers_range_ref(buffers)) {
      const std::size_t size = std::min(count, part.size());
      if (!fragments_->take(static_cast<const std::uint8_t*>(part.data()), size)) return false;
      count -= size;
    }
    return true;
  }

  wire::TlsSettings settings_;
  std::unique_ptr<Tls> tls_;
  std::unique_ptr<boost::beast::tcp_stream> plain_;
  std::unique_ptr<FragmentCount> fragments_;  // null: the stream carries HTTP
};

/// Reads and discards what a browser still sends after the server's close frame. A socket that is closed with unread
/// bytes resets the connection, and the browser then loses the close frame. Ends when the browser closes, or after
/// kMostDiscarded bytes. Beast's own teardown ends after its first read.
template <class Handler>
class Discard {
 public:
  using executor_type = boost::asio::associated_executor_t<Handler, boost::asio::ip::tcp::socket::executor_type>;

  Discard(boost::asio::ip::tcp::socket& socket, Handler handler)
      : socket_(&socket), handler_(std::move(handler)), bytes_(std::make_unique<std::array<char, 4096>>()) {}

  executor_type get_executor() const { return boost::asio::get_associated_executor(handler_, socket_->get_executor()); }

  static void start(Discard self) {
    auto& socket = *self.socket_;
    const auto buffer = boost::asio::buffer(*self.bytes_);
    socket.async_read_some(buffer, std::move(self));
  }

  void operator()(boost::system::error_code failed, std::size_t count) {
    left_ -= std::min(count, left_);
    if (!failed && left_ > 0) return start(std::move(*this));
    boost::system::error_code ignored;
    socket_->close(ignored);
    if (failed == boost::asio::error::eof) failed = {};
    std::move(handler_)(failed);
  }

 private:
  static constexpr std::size_t kMostDiscarded = 4 << 20;  // limit for a peer that never stops sending

  boost::asio::ip::tcp::socket* socket_;  // the socket's owner outlives the teardown
  Handler handler_;
  std::unique_ptr<std::array<char, 4096>> bytes_;
  std::size_t left_ = kMostDiscarded;
};

/// Beast calls these two functions at the end of a WebSocket. The close frame has been exchanged inside TLS, so TLS's
/// own close_notify is not sent.
template <class Handler>
void async_teardown(boost::beast::role_type, WebStream& stream, Handler&& handler) {
  boost::system::error_code ignored;  // if the peer is gone, the read fails and ends the teardown
  stream.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  using Op = Discard<std::decay_t<Handler>>;
  Op::start(Op(stream.socket(), std::forward<Handler>(handler)));
}
inline void beast_close_socket(WebStream& stream) {
  boost::system::error_code ignored;
  stream.socket().close(ignored);
}

}  // namespace telepalp::gateway
