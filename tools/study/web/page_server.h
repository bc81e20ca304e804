#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "tools/study/web/door.h"
#include "tools/study/web/page_files.h"

namespace telepalp::study {

/// What an open page and the program say to each other: texts, which both may send at any time. Owner: the network
/// thread.
class Conversation {
 public:
  virtual ~Conversation() = default;
  /// The first text to the page.
  [[nodiscard]] virtual std::string greeting() = 0;
  /// A text of the page, which nobody has checked.
  virtual void hear(std::string_view message) = 0;
  /// `seconds` of real time have passed. Returns what the page draws now; nullopt: nothing moves until the next hear().
  [[nodiscard]] virtual std::optional<std::string> step(double seconds) = 0;
};
using Say = std::function<void(std::string)>;

/// What a PageServer serves.
struct Page {
  PageFiles files;
  /// Begins the conversation of one page, whose texts to the page go by `say`.
  std::function<std::unique_ptr<Conversation>(const boost::asio::any_io_executor&, Say say)> open;
  std::size_t most_message_bytes = 1024;  ///< a longer text of the page closes it
};

/// Serves a page over HTTP, and for each open page a WebSocket at /live?token=…, by which a Conversation is led. The
/// files have no secret; the WebSocket needs the token. At most kMostConnections connections; a new one closes the
/// oldest. Owner: the network thread.
class PageServer {
 public:
  static constexpr std::size_t kMostConnections = 32;

  /// With port 0 it takes any free port, and door() tells which. Error: the port cannot be opened.
  [[nodiscard]] static Result<std::unique_ptr<PageServer>> open(boost::asio::io_context& io, Door door, Page page);
  /// Closes the connections of all pages, and destroys their Conversations.
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  [[nodiscard]] const Door& door() const noexcept { return shared_->door; }

  /// What all connections share.
  struct Shared {
    Door door;
    Page page;
  };
  class Connection;  ///< one of a browser

 private:
  PageServer(boost::asio::ip::tcp::acceptor acceptor, std::shared_ptr<const Shared> shared);
  void accept();
  void admit(boost::asio::ip::tcp::socket socket);
  void add(const std::shared_ptr<Connection>& connection);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  std::shared_ptr<const Shared> shared_;               // shared with the connections, whose last handler may run later
  std::deque<std::weak_ptr<Connection>> connections_;  // oldest first
};

}  // namespace telepalp::study
