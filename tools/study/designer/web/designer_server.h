#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <memory>

#include "tools/study/designer/background.h"
#include "tools/study/designer/live_design.h"
#include "tools/study/designer/web/door.h"
#include "tools/study/designer/web/page_files.h"

namespace telepalp::study {

/// Serves the designer's page over HTTP, and for each open page a WebSocket at /live?token=…, by which it sends
/// commands (command.h) and gets answers (answers.h). The files have no secret; the WebSocket needs the token. At most
/// kMostConnections connections; a new one closes the oldest. Owner: the network thread.
class DesignerServer {
 public:
  static constexpr std::size_t kMostConnections = 32;

  /// With port 0 it takes any free port, and door() tells which. Error: the port cannot be opened, or a file of the
  /// page is missing.
  [[nodiscard]] static Result<std::unique_ptr<DesignerServer>> open(boost::asio::io_context& io, Door door,
                                                                    Workers& workers);
  /// Closes all connections, and gives up what was computed for them.
  ~DesignerServer();
  DesignerServer(const DesignerServer&) = delete;
  DesignerServer& operator=(const DesignerServer&) = delete;

  [[nodiscard]] const Door& door() const noexcept { return shared_->door; }

  /// What all connections share.
  struct Shared {
    Door door;
    PageFiles files;
    Workers& workers;
    LiveDesign first;  ///< with which each page begins, because its tissue takes long to make
  };
  class Connection;  ///< one of a browser

 private:
  DesignerServer(boost::asio::ip::tcp::acceptor acceptor, std::shared_ptr<const Shared> shared);
  void accept();
  void admit(boost::asio::ip::tcp::socket socket);
  void add(const std::shared_ptr<Connection>& connection);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer accept_again_;
  std::shared_ptr<const Shared> shared_;               // shared with the connections, whose last handler may run later
  std::deque<std::weak_ptr<Connection>> connections_;  // oldest first
};

}  // namespace telepalp::study
