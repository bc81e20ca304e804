#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "messages/control.pb.h"
#include "proto/keys/key_file.h"
#include "proto/words/result.h"

namespace telepalp::meet {

/// The site's end of the meeting point: dials it, joins under the names of the site's key, and hands over the
/// connections of callers. When the connection is lost, it dials again, after 0.5 s, then each time after twice as
/// long, up to 5 s. When this computer has lost the address from which it dialled, or a router has lost
/// the connection, it dials at once and says so, so that the meeting point ends the callers' connections, through which
/// nothing more passes, and they call again. Owner: `io`'s one thread.
class MeetDialer {
 public:
  struct Caller {
    bool is_browser = false;
    std::string from;  ///< the caller's address as the meeting point states it, which may lie
  };
  struct Options {
    std::string host;
    std::uint16_t port = 443;
    std::shared_ptr<const keys::KeyFile> key;  ///< the server's
    /// Gets a caller's connection, of which the TLS greeting has not been read.
    std::function<void(boost::asio::ip::tcp::socket, const Caller&)> on_caller;
    /// False: the site does not take this caller.
    std::function<bool(const Caller&)> takes = [](const Caller&) { return true; };
    std::function<void(const std::string&)> log = [](const std::string&) {};
    /// Whether this computer still has an address. Empty function: the system is asked.
    std::function<bool(const boost::asio::ip::address&)> has_address{};
  };

  /// Error: the key cannot be used.
  [[nodiscard]] static Result<std::unique_ptr<MeetDialer>> start(boost::asio::io_context& io, Options options);
  ~MeetDialer();
  MeetDialer(const MeetDialer&) = delete;
  MeetDialer& operator=(const MeetDialer&) = delete;

  /// The meeting point has taken this site in.
  [[nodiscard]] bool has_joined() const noexcept;
  /// The relay beside the meeting point, with the newest credentials; empty: it named none that may be used.
  [[nodiscard]] std::vector<msg::IceRelay> relays() const;

 private:
  class Line;
  explicit MeetDialer(std::shared_ptr<Line> line);
  std::shared_ptr<Line> line_;  // shared with its pending operations
};

}  // namespace telepalp::meet
