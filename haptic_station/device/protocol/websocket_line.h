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

/// Error: no ws:// URL, no port, characters that do not belong there. `where` names the option. What leaves out its
/// port or path gets `standard`'s.
[[nodiscard]] Result<WebSocketUrl> parse_websocket_url(std::string_view text, const WebSocketUrl& standard,
                                                       std::string_view where);
[[nodiscard]] std::string to_string(const WebSocketUrl& url);

/// A WebSocket client that stays: it connects again when the line is lost, and counts a line on which nothing comes as
/// lost. Texts larger than the bound end the connection, not the program. Owner: the io_context's one thread.
class WebSocketLine {
 public:
  struct Settings {
    std::size_t most_text_bytes = 64U << 10U;
    std::chrono::milliseconds silence{1000};     ///< nothing came for so long: connect again
    std::chrono::milliseconds again_after{250};  ///< between attempts
  };
  struct Handlers {
    std::function<void()> on_open;
    std::function<void(std::string_view)> on_text;
    std::function<void(const std::string&)> on_lost;  ///< why; also each time that connecting failed
  };

  WebSocketLine(boost::asio::io_context& io, WebSocketUrl url, const Settings& settings, Handlers handlers);
  ~WebSocketLine();
  WebSocketLine(const WebSocketLine&) = delete;
  WebSocketLine& operator=(const WebSocketLine&) = delete;

  void start();
  /// Sends `text`; one that is still on its way is never joined by a second one: the newest waits, others are dropped.
  void send(std::string text);
  void stop();

 private:
  class Connection;
  struct Shared;
  void connect();

  std::shared_ptr<Shared> shared_;  // shared: handlers that have fired outlive the line
};

}  // namespace telepalp::device
