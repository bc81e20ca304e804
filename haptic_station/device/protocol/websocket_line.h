#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::device {

/// `ws://HOST:PORT/PATH`.
struct WebSocketUrl {
  std::string host;
  std::uint16_t port = 0;
  std::string path = "/";
};

/// Parses a ws:// URL. A missing port, and a missing path or the path `/`, come from `standard`. `where`: the option's
/// name, for errors. Error: another scheme, over 512 characters, no host, an invalid port, or invalid characters.
[[nodiscard]] Result<WebSocketUrl> parse_websocket_url(std::string_view text, const WebSocketUrl& standard,
                                                       std::string_view where);
[[nodiscard]] std::string to_string(const WebSocketUrl& url);

/// A WebSocket client that reconnects when the connection is lost. A connection without a message for 1 s counts as
/// lost. A text larger than `most_text_bytes` ends the connection. Owner: the io_context's one thread.
class WebSocketLine {
 public:
  struct Settings {
    std::size_t most_text_bytes = 64U << 10U;
  };
  struct Handlers {
    std::function<void()> on_open;
    std::function<void(std::string_view)> on_text;
    std::function<void(const std::string&)> on_lost;  ///< gets the reason; also after each failed attempt
  };

  WebSocketLine(boost::asio::io_context& io, WebSocketUrl url, const Settings& settings, Handlers handlers);
  ~WebSocketLine();
  WebSocketLine(const WebSocketLine&) = delete;
  WebSocketLine& operator=(const WebSocketLine&) = delete;

  void start();
  /// Sends `text`. While an earlier text is being written, only the newest text waits; older waiting texts are dropped.
  void send(std::string text);
  void stop();

 private:
  class Connection;
  struct Shared;

  std::shared_ptr<Shared> shared_;  // shared: pending Asio handlers may outlive this object
};

}  // namespace telepalp::device
