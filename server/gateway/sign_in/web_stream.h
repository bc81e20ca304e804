#pragma once

#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/teardown.hpp>
#include <memory>
#include <utility>

#include "proto/wire/tls_stream.h"

namespace telepalp::server {

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
  template <class Buffers, class Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    if (tls_) return void(tls_->async_read_some(buffers, std::forward<Handler>(handler)));
    plain_->async_read_some(buffers, std::forward<Handler>(handler));
  }
  template <class Buffers, class Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    if (tls_) return void(tls_->async_write_some(buffers, std::forward<Handler>(handler)));
    plain_->async_write_some(buffers, std::forward<Handler>(handler));
  }

 private:
  using Tls = boost::asio::ssl::stream<boost::beast::tcp_stream>;
  wire::TlsSettings settings_;
  std::unique_ptr<Tls> tls_;
  std::unique_ptr<boost::beast::tcp_stream> plain_;
};

/// Beast calls these at the end of a WebSocket. The close frame has been exchanged inside the session, so that TLS's
/// own close_notify would add nothing.
template <class Handler>
void async_teardown(boost::beast::role_type role, WebStream& stream, Handler&& handler) {
  boost::beast::websocket::async_teardown(role, stream.socket(), std::forward<Handler>(handler));
}
inline void beast_close_socket(WebStream& stream) {
  boost::system::error_code ignored;
  stream.socket().close(ignored);
}

}  // namespace telepalp::server
